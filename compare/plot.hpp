#pragma once

#include <optional>
#include <string>
#include <vector>

namespace meniscus::compare {

/// A curve with marks at its points. Points that an axis cannot show (0 on a logarithmic one) are
/// left out.
struct Series {
    struct Point {
        double x, y;
    };
    std::string name;
    std::vector<Point> points;
    bool dashed = false, marks = true;
    std::optional<std::vector<Point>> line = {};  // where it is not to go from point to point
};

/// Both axes are logarithmic, in whole powers of ten.
struct Plot {
    std::string title, x_label, y_label;
    std::vector<Series> series;
};

/// As SVG that shows itself in light and dark; on its own or inside a page.
std::string draw(const Plot& plot);

/// Counts as bars of logarithmic height.
struct Bars {
    struct Bar {
        std::string label;  // below the bar; empty: none
        std::string what;   // said of the bar: "1e-3 to 3.2e-3"
        double count;
    };
    std::string title, x_label, y_label;
    std::vector<Bar> bars;
};

std::string draw(const Bars& bars);

}  // namespace meniscus::compare
