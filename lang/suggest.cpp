#include "lang/suggest.hpp"

#include <algorithm>
#include <cctype>

namespace meniscus::lang {
namespace {

constexpr std::size_t longest_word = 64;

/// How many letters must be put in, left out, changed or swapped with their neighbour; a change of
/// case counts as half a letter (so all is counted in halves).
int edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = static_cast<int>(2 * i);
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = static_cast<int>(2 * j);
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int change = a[i - 1] == b[j - 1]                 ? 0
                               : lower(a[i - 1]) == lower(b[j - 1]) ? 1
                                                                    : 2;
            d[i][j] = std::min({d[i - 1][j] + 2, d[i][j - 1] + 2, d[i - 1][j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 2);
            }
        }
    }
    return d[a.size()][b.size()];
}

template <class Words>
std::string nearest(std::string_view word, const Words& known) {
    if (word.size() > longest_word) return {};
    std::string best;
    // up to a third of the letters; of a very short word only the case may differ
    int least = word.size() < 3 ? 2 : static_cast<int>(word.size()) * 2 / 3 + 1;
    for (const auto& candidate : known) {
        const std::string_view other = candidate;
        if (other.size() > word.size() + 4 || word.size() > other.size() + 4 || other == word)
            continue;
        const int distance = edit_distance(word, other);
        if (distance < least || (distance == least && !best.empty() && other < best)) {
            least = distance;
            best = other;
        }
    }
    return best.empty() ? best : "; did you mean '" + best + "'?";
}

}  // namespace

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
    return nearest(word, known);
}
std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
    return nearest(word, known);
}

}  // namespace meniscus::lang
