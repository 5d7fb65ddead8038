#include "engine/study/plot.hpp"

#include "engine/study/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace demlua::study {

namespace {

// Sizes in px.
constexpr double width = 720.0;
constexpr double left = 84.0;
constexpr double right = 20.0;
constexpr double top = 44.0;
constexpr double frame_height = 360.0;
constexpr double below = 58.0; ///< for the labels of the lower axis
constexpr double entry_height = 20.0;
constexpr double frame_width = width - left - right;

/// Colours that stay apart for colour-blind readers and in print.
constexpr std::array<std::string_view, 7> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#56b4e9", "#e69f00", "#000000"};

std::string_view colour_of(std::size_t curve) { return colours[curve % colours.size()]; }

bool drawable(const Point& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && point.x > 0.0 && point.y > 0.0;
}

std::vector<Point> drawable(std::vector<Point> points) {
    points.erase(std::remove_if(points.begin(), points.end(), [](const Point& point) { return !drawable(point); }),
                 points.end());
    return points;
}

/// From values to places in the picture.
struct Frame {
    Axis x;
    Axis y;

    [[nodiscard]] double column(double value) const {
        return left + frame_width * std::log(value / x.low) / std::log(x.high / x.low);
    }
    [[nodiscard]] double row(double value) const {
        return top + frame_height * (1.0 - std::log(value / y.low) / std::log(y.high / y.low));
    }
};

Frame frame_of(const Plot& plot) {
    std::vector<double> xs;
    std::vector<double> ys;
    for (const Curve& curve : plot.curves) {
        for (const auto* points : {&curve.points, &curve.single}) {
            for (const Point& point : drawable(*points)) {
                xs.push_back(point.x);
                ys.push_back(point.y);
            }
        }
    }
    return {axis_over(xs), axis_over(ys)};
}

std::string text_at(double x, double y, std::string_view anchor, const std::string& text, std::string_view more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                       escaped(text));
}

std::string stroke(double x1, double y1, double x2, double y2, std::string_view style) {
    return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x1, y1, x2, y2, style);
}

std::string axes(const Plot& plot, const Frame& frame) {
    constexpr std::string_view grid = "stroke=\"#d8d8d8\"";
    constexpr std::string_view fine_grid = "stroke=\"#f0f0f0\"";
    const double bottom = top + frame_height;
    std::string text;
    for (const Tick& tick : frame.x.ticks) {
        const double x = frame.column(tick.value);
        text += stroke(x, top, x, bottom, tick.label.empty() ? fine_grid : grid);
        if (!tick.label.empty()) text += text_at(x, bottom + 18.0, "middle", tick.label);
    }
    for (const Tick& tick : frame.y.ticks) {
        const double y = frame.row(tick.value);
        text += stroke(left, y, left + frame_width, y, tick.label.empty() ? fine_grid : grid);
        if (!tick.label.empty()) text += text_at(left - 8.0, y + 4.0, "end", tick.label);
    }
    text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#404040\"/>\n", left,
                        top, frame_width, frame_height);
    text += text_at(left + frame_width / 2.0, bottom + 42.0, "middle", plot.x_label);
    const double middle = top + frame_height / 2.0;
    return text +
           text_at(20.0, middle, "middle", plot.y_label, fmt::format(" transform=\"rotate(-90 20 {})\"", middle));
}

/// One of a few shapes, so that curves can be told apart without colour.
std::string mark(double x, double y, double r, std::size_t curve) {
    const auto style = fmt::format("fill=\"{}\"", colour_of(curve));
    const auto polygon = [&](const std::string& corners) {
        return fmt::format("<polygon points=\"{}\" {}/>\n", corners, style);
    };
    switch (curve % 4) {
    case 1:
        return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n", x - r, y - r,
                           2.0 * r, 2.0 * r, style);
    case 2:
        return polygon(fmt::format("{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}", x, y - 1.3 * r, x - 1.2 * r, y + r,
                                   x + 1.2 * r, y + r));
    case 3:
        return polygon(fmt::format("{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}", x, y - 1.4 * r,
                                   x + 1.4 * r, y, x, y + 1.4 * r, x - 1.4 * r, y));
    default:
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" {}/>\n", x, y, r, style);
    }
}

std::string drawn(const Curve& curve, std::size_t index, const Frame& frame) {
    std::string path;
    std::string marks;
    for (const Point& point : drawable(curve.single)) {
        marks += fmt::format("<g opacity=\"0.45\">{}</g>", mark(frame.column(point.x), frame.row(point.y), 2.0, index));
    }
    for (const Point& point : drawable(curve.points)) {
        path += fmt::format("{:.1f},{:.1f} ", frame.column(point.x), frame.row(point.y));
        marks += mark(frame.column(point.x), frame.row(point.y), 4.5, index);
    }
    return fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" stroke-opacity=\"0.4\"/>\n{}", path,
        colour_of(index), marks);
}

std::string dashed(std::size_t curve) {
    return fmt::format("stroke=\"{}\" stroke-width=\"1.4\" stroke-dasharray=\"6 4\"", colour_of(curve));
}

std::string drawn(const Line& line, const Frame& frame) {
    const auto y = [&](double x) { return frame.row(line.factor * std::pow(x, line.slope)); };
    return fmt::format("<g clip-path=\"url(#frame)\">{}</g>\n",
                       stroke(left, y(frame.x.low), left + frame_width, y(frame.x.high), dashed(line.curve)));
}

std::string legend(const Plot& plot) {
    std::string text;
    double y = top + frame_height + below + entry_height / 2.0;
    for (std::size_t k = 0; k < plot.curves.size(); ++k) {
        text += mark(left + 14.0, y, 4.5, k);
        text += text_at(left + 36.0, y + 4.0, "start", plot.curves[k].name);
        y += entry_height;
    }
    for (const Line& line : plot.lines) {
        text += stroke(left, y, left + 28.0, y, dashed(line.curve));
        text += text_at(left + 36.0, y + 4.0, "start", line.name);
        y += entry_height;
    }
    return text;
}

bool nothing_to_draw(const Plot& plot) {
    return std::all_of(plot.curves.begin(), plot.curves.end(), [](const Curve& curve) {
        return drawable(curve.points).empty() && drawable(curve.single).empty();
    });
}

} // namespace

std::string escaped(const std::string& text) {
    std::string made;
    for (const char c : text) {
        switch (c) {
        case '&':
            made += "&amp;";
            break;
        case '<':
            made += "&lt;";
            break;
        case '>':
            made += "&gt;";
            break;
        case '"':
            made += "&quot;";
            break;
        default:
            made += c;
        }
    }
    return made;
}

std::string svg_of(const Plot& plot) {
    const auto entries = static_cast<double>(plot.curves.size() + plot.lines.size());
    const double height = top + frame_height + below + entry_height * entries + 8.0;
    std::string text = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
                                   "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"13\" "
                                   "fill=\"#202020\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
                                   width, height);
    text += text_at(left + frame_width / 2.0, 26.0, "middle", plot.title, " font-size=\"15\" font-weight=\"bold\"");
    const Frame frame = frame_of(plot);
    if (nothing_to_draw(plot)) {
        return text + text_at(width / 2.0, top + frame_height / 2.0, "middle", plot.instead) + "</svg>\n";
    }
    text += axes(plot, frame);
    text += fmt::format("<clipPath id=\"frame\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n",
                        left, top, frame_width, frame_height);
    for (std::size_t k = 0; k < plot.curves.size(); ++k) text += drawn(plot.curves[k], k, frame);
    for (const Line& line : plot.lines) text += drawn(line, frame);
    return text + legend(plot) + "</svg>\n";
}

} // namespace demlua::study
