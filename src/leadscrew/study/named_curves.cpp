#include <array>
#include <leadscrew/study/blended_programs.hpp>
#include <leadscrew/study/named_curves.hpp>
#include <leadscrew/study/optima.hpp>

namespace leadscrew::study {

namespace {

constexpr std::array<NamedCurve, 4> all = {{
    {"plane-cubic", 10, [](double feed) { return cubic_optima().program(feed); }},
    {"plane-cubic-lines", 10, [](double feed) { return stopping(cubic_as_lines(feed)); }},
    {"circle", 10, [](double feed) { return circle_optima().program(feed); }},
    {"butterfly", 100, [](double feed) { return butterfly_optima().program(feed); }},
}};

}  // namespace

std::span<const NamedCurve> named_curves() {
  return all;
}

}  // namespace leadscrew::study
