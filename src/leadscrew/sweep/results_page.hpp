#pragma once
// DIR/results.html: what a sweep says to someone who decides. Time against tolerance, limits and machines; where time is lost
// over all programs; what was refused, once a machine; what did not keep a promise; of a campaign the worst of each kind.

#include <array>
#include <cstdint>
#include <leadscrew/json/json.hpp>
#include <leadscrew/sweep/summary.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace leadscrew::sweep {

/// The parameters that a row names, as numbers; NaN where those of the program and the machine hold.
inline constexpr std::array<std::string_view, 6> parameter_names = {"tolerance_mm", "override",     "period_us",
                                                                    "velocity",     "acceleration", "jerk"};
using ParameterValues = std::array<double, parameter_names.size()>;

/// Gets the rows in the order of tasks, and keeps a number of each.
class ResultsPage {
 public:
  void observe(const json::Json& row);

  /// One file that needs no other. `folder` as its title.
  std::string written(const Summary& summary, const std::string& folder) const;

 private:
  /// A machine with values of all parameters.
  struct Variant {
    std::size_t machine = 0;
    ParameterValues values{};
  };
  /// Of programs that ran in every variant that is meant.
  struct Times {
    std::int64_t programs = 0;
    std::vector<double> by_variant;  ///< s
  };
  struct Refusal {
    std::string program, machine, code, message;
    std::int64_t line = 0;
    std::int64_t variants = 0;  ///< in which it was refused
  };
  struct Broken {
    std::string place, what;
  };
  /// Of a campaign's cases.
  struct Kind {
    std::int64_t cases = 0, broken = 0;
    double time_s = 0;
    std::array<double, 5> worst{};  ///< velocity, acceleration, jerk, feed, deviation over their limits
  };
  /// Of all programs in the first variant of a machine.
  struct Lost {
    double time_s = 0;
    std::map<std::string, double> by_cause;  ///< s
  };

  void observe_case(const json::Json& row, const std::string& kind);
  void observe_program(const json::Json& row);
  void observe_time(const json::Json& row, std::size_t variant);
  void refuse(const json::Json& row);
  std::size_t variant_of(const json::Json& row);
  /// Of a machine's variants, or of all.
  Times times(std::optional<std::size_t> machine = {}) const;
  /// The first of a machine.
  std::size_t first_of(std::size_t machine) const;

  void put_times(std::string& page) const;
  void put_chart(std::string& page, const std::vector<Times>& of_machines, std::size_t parameter) const;
  void put_machines(std::string& page) const;
  void put_losses(std::string& page) const;
  void put_kinds(std::string& page) const;
  void put_broken(std::string& page) const;
  void put_refusals(std::string& page) const;

  std::vector<std::string> machines_;
  std::vector<Variant> variants_;
  std::map<std::pair<std::size_t, std::string>, std::size_t> known_variants_;
  std::string program_;                     // of the rows that come
  std::vector<std::vector<double>> times_;  // of each program by variant, s; NaN: it has none there
  std::vector<Lost> lost_;                  // by machine
  std::vector<Refusal> refusals_;
  std::vector<Broken> broken_;
  std::int64_t more_refusals_ = 0, more_broken_ = 0;  // that are not kept
  std::map<std::string, Kind> kinds_;
};

/// The files page.css and page.js, embedded. The page is complete without the script, which sorts tables.
extern const std::string_view page_css, page_js;

}  // namespace leadscrew::sweep
