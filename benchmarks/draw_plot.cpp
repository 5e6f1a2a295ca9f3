// draw_plot IN.json OUT.svg: {"title": "", "x": "", "y": "", "series": [{"name": "", "points": [[1,
// 2]]}]}
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compare/plot.hpp"
#include "image/file.hpp"

int main(int argc, char** argv) try {
    if (argc != 3) {
        fmt::print(stderr, "usage: draw_plot IN.json OUT.svg\n");
        return 2;
    }
    const auto json = nlohmann::json::parse(meniscus::image::read_file(argv[1]));
    meniscus::compare::Plot plot{json.at("title"), json.at("x"), json.at("y"), {}};
    for (const auto& from : json.at("series")) {
        meniscus::compare::Series series{from.at("name"), {}};
        for (const auto& point : from.at("points"))
            series.points.push_back({point.at(0), point.at(1)});
        plot.series.push_back(std::move(series));
    }
    meniscus::image::write_file(argv[2], meniscus::compare::draw(plot));
    return 0;
} catch (const std::exception& error) {
    fmt::print(stderr, "draw_plot: {}\n", error.what());
    return 1;
}
