#include <leadscrew/study/bounds.hpp>
#include <leadscrew/study/studies.hpp>

namespace leadscrew::study {

Rows bounds_to(const Host& host, std::int64_t radius) {
  Rows rows = circle_bounds(host, radius);
  append(rows, arc_bounds(host));
  append(rows, free_circle_bounds(host));
  append(rows, line_bounds(host));
  return rows;
}

Rows bounds_rows(const Host& host) {
  return bounds_to(host, 4096);
}

}  // namespace leadscrew::study
