#include <charconv>
#include <cmath>
#include <iterator>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/study/row.hpp>
#include <utility>

namespace leadscrew::study {

namespace {

Row row(std::string what, Scale scale, Reference figure, double ours, Verdict verdict) {
  return {{}, std::move(what), figure.published, figure.expected, ours, scale, verdict, {}};
}

bool rounds_to(double figure, double ours, const Scale& scale, double accuracy) {
  // The figure itself is a decimal fraction: half a unit of its last digit, and what binary makes of it.
  const double half_digit = 0.5 * std::pow(10, -scale.decimals) * (1 + 1e-9);
  return std::abs(ours - figure) <= half_digit + accuracy;
}

}  // namespace

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::exact:
      return "exact";
    case Verdict::reproduced:
      return "reproduced";
    case Verdict::differs:
      return "differs";
    case Verdict::fitted:
      return "fitted";
    case Verdict::no_worse:
      return "no worse";
    case Verdict::worse:
      return "worse";
    case Verdict::kept:
      return "kept";
    case Verdict::exceeded:
      return "exceeded";
    case Verdict::measured:
      return "measured";
    case Verdict::not_run:
      return "not run";
    case Verdict::not_reproducible:
      return "not reproducible";
  }
  return "";
}

Row exact_row(std::string what, Scale scale, Reference figure, double ours, double accuracy) {
  const bool equal = rounds_to(figure.value(), ours, scale, accuracy);
  return row(std::move(what), scale, figure, ours, equal ? Verdict::exact : Verdict::differs);
}

Row reproduced_row(std::string what, Scale scale, Reference figure, double ours, double accuracy) {
  const bool near = std::abs(ours - figure.value()) <= accuracy;
  return row(std::move(what), scale, figure, ours, near ? Verdict::reproduced : Verdict::differs);
}

Row fitted_row(std::string what, Scale scale, Published figure, double ours) {
  const bool equal = rounds_to(figure.value, ours, scale, 0);
  return row(std::move(what), scale, figure, ours, equal ? Verdict::fitted : Verdict::differs);
}

Row at_most_row(std::string what, Scale scale, Reference figure, double ours, double accuracy) {
  const Verdict verdict = ours <= figure.value() + accuracy ? Verdict::no_worse : Verdict::worse;
  return row(std::move(what), scale, figure, ours, verdict);
}

Row limit_row(std::string what, Scale scale, Reference limit, double ours, double accuracy) {
  const Verdict verdict = ours <= limit.value() + accuracy ? Verdict::kept : Verdict::exceeded;
  return row(std::move(what), scale, limit, ours, verdict);
}

Row measured_row(std::string what, Scale scale, double ours) {
  return {{}, std::move(what), {}, {}, ours, scale, Verdict::measured, {}};
}

Row not_run_row(std::string what, std::string why) {
  return {{}, std::move(what), {}, {}, {}, {}, Verdict::not_run, std::move(why)};
}

Row not_reproducible_row(std::string what, Scale scale, Reference figure, std::string why) {
  return {{}, std::move(what), figure.published, figure.expected, {}, scale, Verdict::not_reproducible, std::move(why)};
}

Row because(Row row, std::string why) {
  row.why = std::move(why);
  return row;
}

Row expecting(Row row, double expected) {
  row.expected = expected;
  return row;
}

Rows under(const std::string& group, Rows rows) {
  for (Row& each : rows) each.group = group;
  return rows;
}

void append(Rows& rows, Rows more) {
  rows.insert(rows.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::string decimal(double value, int decimals) {
  const bool vanishes = value != 0 && std::abs(value) < 0.5 * std::pow(10, -decimals);
  if (!vanishes) return base::fixed_text(value, decimals);
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific, 1);
  return {buffer, end.ptr};
}

}  // namespace leadscrew::study
