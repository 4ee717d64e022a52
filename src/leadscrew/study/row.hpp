#pragma once
// One line of a study: a published figure, ours beside it, and what to think of the two.
//
// Verdicts are computed from the figures, never written down: each function below states its rule.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::study {

enum class Verdict : std::uint8_t {
  exact,             ///< equal to every digit that was published
  reproduced,        ///< within the accuracy that is told of the published figure
  differs,           ///< neither
  no_worse,          ///< as good as the published figure, or better
  worse,             ///< not as good
  kept,              ///< within the limit
  exceeded,          ///< beyond the limit
  measured,          ///< nothing was published to compare with
  not_run,           ///< could not be measured; `why` says why
  not_reproducible,  ///< a figure of equipment that is not here; `why` says which
};

/// "exact", "no worse", …
std::string_view name(Verdict verdict);

/// How a figure is counted and how many digits after the point say something.
struct Scale {
  std::string_view unit;  ///< such as "s", "mm", "%"; empty for plain numbers; static storage
  int decimals = 0;       ///< as published, or as far as ours can be trusted; 0 … 12
};

struct Row {
  std::string group;                ///< the circumstances: curve, feed, limits; may be empty
  std::string what;                 ///< what was measured
  std::optional<double> published;  ///< in `scale.unit`
  std::optional<double> ours;       ///< in `scale.unit`
  Scale scale;
  Verdict verdict = Verdict::measured;
  std::string why;  ///< definition, accuracy or cause; may be empty
};
using Rows = std::vector<Row>;

/// Exact where ours rounds to the published decimals, allowing for `accuracy` (≥ 0) of ours; else differs.
Row exact_row(std::string what, Scale scale, double published, double ours, double accuracy = 0);
/// Reproduced where |ours − published| ≤ accuracy; else differs.
Row reproduced_row(std::string what, Scale scale, double published, double ours, double accuracy);
/// No worse where ours ≤ published + accuracy; else worse.
Row at_most_row(std::string what, Scale scale, double published, double ours, double accuracy = 0);
/// Kept where ours ≤ limit + accuracy; else exceeded.
Row limit_row(std::string what, Scale scale, double limit, double ours, double accuracy = 0);
Row measured_row(std::string what, Scale scale, double ours);
Row not_run_row(std::string what, std::string why);
Row not_reproducible_row(std::string what, Scale scale, double published, std::string why);

/// The row, with a word on it.
Row because(Row row, std::string why);
/// The rows under one heading, with that heading.
Rows under(const std::string& group, Rows rows);
void append(Rows& rows, Rows more);

/// The value with this many digits after the point (0 … 12); scientific below half of the last of them.
std::string decimal(double value, int decimals);

}  // namespace leadscrew::study
