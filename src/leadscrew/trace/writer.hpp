#pragma once
// What a format of words has to offer.
//
// Columns are `t line s feed X Y Z …`: seconds, source line, path length, feed, then the machine's axes; mm, degrees,
// seconds. Others stand behind them.

#include <array>
#include <concepts>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/base/sink.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/base/word.hpp>
#include <span>
#include <string>
#include <string_view>

namespace leadscrew::trace {

/// Which columns a trace has behind those of the words, in this order.
struct MoreColumns {
  bool actual = false;  ///< of slides that followed the words: those of slide_columns
  bool power = false;   ///< power: of the laser
  bool pose = false;    ///< tx ty tz i j k: where words bring the tool's tip, and its direction
};

/// Of a pose: the tip in the workpiece, and the unit vector from it to the spindle.
struct PoseColumn {
  std::string_view name;  ///< in the header
  std::string_view unit;  ///< mm; "" of a direction
};
/// The tip's position, and the tool's direction.
inline constexpr std::array<PoseColumn, 6> pose_columns = {
    {{"tx", "mm"}, {"ty", "mm"}, {"tz", "mm"}, {"i", ""}, {"j", ""}, {"k", ""}}};

/// What they hold in the row of a word.
struct BesideWord {
  base::AxisVector actual{};    ///< where the slides were, mm or degrees
  base::AxisVector velocity{};  ///< of the screws, by the tachometers, mm/s or degrees/s
  base::AxisVector control{};   ///< of the period that begins: what the controllers give their drives (servo::Followed)
  base::AxisVector current{};   ///< of the motors, as the acceleration it gives, mm/s² or degrees/s²
  double power = 0;             ///< machine::LaserPower
  std::array<double, pose_columns.size()> pose{};  ///< as those columns say
};

/// A column for each axis, of this name and the axis' letter: actual_X, actual_Y, …
struct SlideColumn {
  std::string_view name;                  ///< before the letter
  base::AxisVector BesideWord::* values;  ///< what it holds
  std::string_view linear;                ///< unit of linear axes; empty where each controller has its own
  std::string_view rotary;                ///< unit of rotary axes
};
/// In their order: a column an axis for each.
inline constexpr std::array<SlideColumn, 4> slide_columns = {{{"actual_", &BesideWord::actual, "mm", "deg"},
                                                              {"velocity_", &BesideWord::velocity, "mm/s", "deg/s"},
                                                              {"control_", &BesideWord::control, "", ""},
                                                              {"current_", &BesideWord::current, "mm/s²", "deg/s²"}}};

/// Those that a trace has.
constexpr std::span<const SlideColumn> slide_columns_of(const MoreColumns& columns) {
  return std::span(slide_columns).first(columns.actual ? slide_columns.size() : 0);
}

/// Columns at most, of axes and all others.
inline constexpr std::size_t most_columns = 5 + pose_columns.size() + (1 + slide_columns.size()) * base::axis_count;

/// Opens a trace by its constructor, takes a word a row, and finishes with what is still gathered. Once the sink has
/// failed, every later call fails with the same diagnostic.
template <class T>
concept Writer = std::constructible_from<T, base::ByteSink, base::AxisSet, base::Period, MoreColumns> &&
                 requires(T writer, const base::Word& word, const BesideWord& beside) {
                   { writer.write(word, beside) } -> std::same_as<base::Result<void>>;
                   { writer.finish() } -> std::same_as<base::Result<void>>;
                 };

/// Its header is complete only at the end: when finish() has succeeded, the caller writes header() over the first
/// header().size() bytes of the file.
template <class T>
concept HeaderLast = Writer<T> && requires(const T writer) {
  { writer.header() } -> std::same_as<std::string>;
};

/// Its file does not say what its columns are.
template <class T>
concept Nameless = Writer<T> && requires { requires T::is_nameless; };

}  // namespace leadscrew::trace
