#include <leadscrew/base/number_text.hpp>
#include <leadscrew/measuring/map_text.hpp>

namespace leadscrew::measuring {

namespace {

constexpr int digits = 12;

void put_number(std::string& row, double value) {
  row += ',';
  row += base::text(value, digits);
}

}  // namespace

MapText::MapText(base::ByteSink sink) : rows_(std::move(sink), 256) {
  rows_.text() += "line,u,v,x,y,z,height\n";
}

base::Result<void> MapText::write(const Measurement& measurement, base::Line line) {
  const PlaceTree& map = measurement.map();
  const GridLines& lines = measurement.lines();
  const std::string number = std::to_string(base::number(line));
  for (std::size_t j = 0; j < map.rows(); ++j) {
    for (std::size_t i = 0; i < map.columns(); ++i) {
      const GridPlace& place = map.at(i, j);
      std::string& row = rows_.text();
      row += number;
      put_number(row, lines.u[i]);
      put_number(row, lines.v[j]);
      for (const double coordinate : place.s) put_number(row, coordinate);
      if (place.height == no_place || place.height >= measurement.target().reach) {
        row += ',';
      } else {
        put_number(row, place.height);
      }
      row += '\n';
      if (auto written = rows_.flush_if_full(); !written) return written;
    }
  }
  return rows_.state();
}

}  // namespace leadscrew::measuring
