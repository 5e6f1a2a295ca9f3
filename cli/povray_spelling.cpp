#include "cli/povray_spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "cli/exit_code.hpp"

namespace meniscus::cli {
namespace {

using Arguments = std::vector<std::string>;

/// "+W320" and "Width=320" mean the same; an empty word has no such form.
struct Spelling {
    std::string_view switch_letters;
    std::string_view setting;
    std::string_view option;
};

/// To add a spelling with one value: name it here; longer letters before their own beginnings.
constexpr auto spellings = std::to_array<Spelling>({
    {"SC", "Start_Column", "--start-column"},
    {"SR", "Start_Row", "--start-row"},
    {"EC", "End_Column", "--end-column"},
    {"ER", "End_Row", "--end-row"},
    {"AM", "Sampling_Method", "--contrast-method"},
    {"WT", "Work_Threads", "--threads"},
    {"O", "Output_File_Name", "--output"},
    {"W", "Width", "--width"},
    {"H", "Height", "--height"},
    {"R", "Antialias_Depth", "--contrast-depth"},
    {"L", "Library_Path", "-L"},
    {"", "Declare", "--declare"},
});

/// They change nothing in a picture of ours: display, pause, verbosity, console streams, jitter
/// off.
constexpr auto ignored_switches = std::to_array<std::string_view>(
    {"-D", "+D", "-P", "+P", "-V", "+V", "-C", "-J", "-GA", "+GA", "+Q9", "+Q10", "+Q11"});
constexpr auto ignored_settings =
    std::to_array<std::string_view>({"Display", "Pause_When_Done", "Verbose"});

/// Options of our own whose value is never one of POV-Ray's switches.
constexpr auto with_free_value =
    std::to_array<std::string_view>({"--declare", "--output", "-o", "-L", "--json"});

bool equal_but_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

bool starts_but_case(std::string_view text, std::string_view start) {
    return text.size() >= start.size() && equal_but_case(text.substr(0, start.size()), start);
}

bool contains(const auto& list, std::string_view word) {
    return std::ranges::any_of(list, [&](auto entry) { return equal_but_case(entry, word); });
}

Arguments antialias(std::string_view threshold) {
    return {"--contrast", threshold.empty() ? "0.3" : std::string(threshold)};
}

Arguments file_type(std::string_view type) {
    if (equal_but_case(type, "N") || equal_but_case(type, "N8")) return {"--format", "png"};
    if (equal_but_case(type, "N16")) return {"--format", "png", "--bits", "16"};
    if (equal_but_case(type, "E")) return {"--format", "exr"};
    throw UsageError(fmt::format("'+F{}': pictures are PNG (+FN, +FN16) or OpenEXR (+FE)", type));
}

Arguments file_gamma(std::string_view gamma) {
    if (equal_but_case(gamma, "sRGB")) return {"--encoding", "srgb"};
    if (gamma == "1" || gamma == "1.0") return {"--encoding", "linear"};
    throw UsageError(fmt::format("'File_Gamma={}': it can be sRGB or 1.0", gamma));
}

Arguments from_switch(const std::string& argument) {
    if (contains(ignored_switches, argument)) return {};
    if (equal_but_case(argument, "-A")) return {"--grid", "1"};
    if (argument.front() != '+') return {argument};
    const auto word = std::string_view(argument).substr(1);
    for (const auto& spelling : spellings)
        if (!spelling.switch_letters.empty() && starts_but_case(word, spelling.switch_letters)) {
            const auto value = word.substr(spelling.switch_letters.size());
            if (value.empty()) throw UsageError(fmt::format("'{}' needs a value", argument));
            return {std::string(spelling.option), std::string(value)};
        }
    if (starts_but_case(word, "I") && word.size() > 1) return {std::string(word.substr(1))};
    if (starts_but_case(word, "A")) return antialias(word.substr(1));
    if (starts_but_case(word, "F")) return file_type(word.substr(1));
    throw UsageError(fmt::format(
        "'{}' is unknown; of POV-Ray's switches there are +I +O +W +H +SC +SR +EC +ER +A +R +AM "
        "+FN +FE +WT +L -A -D",
        argument));
}

Arguments from_setting(std::string_view key, std::string_view value, const std::string& argument) {
    for (const auto& spelling : spellings)
        if (equal_but_case(key, spelling.setting))
            return {std::string(spelling.option), std::string(value)};
    if (contains(ignored_settings, key)) return {};
    if (equal_but_case(key, "Input_File_Name")) return {std::string(value)};
    if (equal_but_case(key, "Output_File_Type")) return file_type(value);
    if (equal_but_case(key, "File_Gamma")) return file_gamma(value);
    return {argument};
}

Arguments translate(const std::string& argument) {
    if (argument.size() < 2) return {argument};
    if (argument[0] == '+' || argument[0] == '-') return from_switch(argument);
    const auto equals = argument.find('=');
    if (equals == std::string::npos) return {argument};
    const auto text = std::string_view(argument);
    return from_setting(text.substr(0, equals), text.substr(equals + 1), argument);
}

}  // namespace

std::vector<std::string> translate_povray_spellings(const std::vector<std::string>& arguments) {
    Arguments translated;
    if (!arguments.empty() && arguments.front().starts_with('+')) translated.push_back("render");
    bool is_value = false;
    for (const auto& argument : arguments) {
        const auto words = is_value ? Arguments{argument} : translate(argument);
        translated.insert(translated.end(), words.begin(), words.end());
        is_value = contains(with_free_value, argument);
    }
    return translated;
}

}  // namespace meniscus::cli
