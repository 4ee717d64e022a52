#pragma once
// One line of a study: a published or an expected figure, ours beside it, and what to think of the two.
//
// Published is what a paper prints or what follows by arithmetic from what it prints, with its source. Whatever else ours
// is compared with is expected: of theory, of a derivation, of another computation, or a limit.
//
// Verdicts are computed from the figures, never written down: each function below states its rule.

#include <cstdint>
#include <leadscrew/study/source.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::study {

enum class Verdict : std::uint8_t {
  exact,             ///< equal to every digit of the figure beside it
  reproduced,        ///< within the accuracy that is told of that figure
  differs,           ///< neither
  fitted,            ///< equal to every digit, for a parameter of ours was solved from the published figure
  no_worse,          ///< as good as the figure beside it, or better
  worse,             ///< not as good
  kept,              ///< within the limit
  exceeded,          ///< beyond the limit
  measured,          ///< there is nothing to compare it with, or it is a variant of a figure compared elsewhere
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

/// What ours is compared with: a published figure, or else, a bare number, one that is expected.
struct Reference {
  std::optional<Published> published;
  std::optional<double> expected;

  Reference(Published figure) : published(figure) {}  // NOLINT(google-explicit-constructor): one or the other
  Reference(double figure) : expected(figure) {}      // NOLINT(google-explicit-constructor)

  double value() const { return published ? published->value : *expected; }
};

struct Row {
  std::string group;                   ///< the circumstances: curve, feed, limits; may be empty
  std::string what;                    ///< what was measured
  std::optional<Published> published;  ///< in `scale.unit`
  std::optional<double> expected;      ///< in `scale.unit`
  std::optional<double> ours;          ///< in `scale.unit`
  Scale scale;
  Verdict verdict = Verdict::measured;
  std::string why;  ///< definition, accuracy or cause; may be empty
};
using Rows = std::vector<Row>;

/// Exact where ours rounds to the figure's decimals, allowing for `accuracy` (≥ 0) of ours; else differs.
Row exact_row(std::string what, Scale scale, Reference figure, double ours, double accuracy = 0);
/// Reproduced where |ours − figure| ≤ accuracy; else differs.
Row reproduced_row(std::string what, Scale scale, Reference figure, double ours, double accuracy);
/// Of figures that a parameter of ours was solved from: fitted where ours rounds to the decimals; else differs.
Row fitted_row(std::string what, Scale scale, Published figure, double ours);
/// No worse where ours ≤ figure + accuracy; else worse.
Row at_most_row(std::string what, Scale scale, Reference figure, double ours, double accuracy = 0);
/// Kept where ours ≤ limit + accuracy; else exceeded.
Row limit_row(std::string what, Scale scale, Reference limit, double ours, double accuracy = 0);
Row measured_row(std::string what, Scale scale, double ours);
Row not_run_row(std::string what, std::string why);
Row not_reproducible_row(std::string what, Scale scale, Reference figure, std::string why);

/// The row, with a word on it.
Row because(Row row, std::string why);
/// The row, with what is expected, beside a published figure that is something else.
Row expecting(Row row, double expected);
/// The rows under one heading, with that heading.
Rows under(const std::string& group, Rows rows);
void append(Rows& rows, Rows more);

/// The value with this many digits after the point (0 … 12); scientific below half of the last of them.
std::string decimal(double value, int decimals);

}  // namespace leadscrew::study
