// A picture with two logarithmic axes, as SVG that needs nothing else.
#pragma once

#include <string>
#include <vector>

namespace demlua::study {

struct Point {
    double x = 0.0;
    double y = 0.0;
};

struct Curve {
    std::string name;               ///< in the legend
    std::vector<Point> points;      ///< joined, in this order
    std::vector<Point> single = {}; ///< small marks beside them, such as single runs
};

/// y = factor x^slope, dashed across the picture in the colour of the curve with that index.
struct Line {
    std::string name; ///< in the legend
    double factor = 1.0;
    double slope = 1.0;
    std::size_t curve = 0;
};

struct Plot {
    std::string title;
    std::string x_label; ///< with its unit
    std::string y_label;
    std::vector<Curve> curves;
    std::vector<Line> lines = {};
    std::string instead = {}; ///< said in place of the curves when there is nothing to draw
};

/// The text of the picture. Coordinates that are not positive and finite are left out.
std::string svg_of(const Plot& plot);

/// Text as it stands in XML and HTML.
std::string escaped(const std::string& text);

} // namespace demlua::study
