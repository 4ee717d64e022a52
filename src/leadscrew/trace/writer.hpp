#pragma once
// What a format of words has to offer.
//
// Columns are `t line s feed X Y Z …`: seconds, source line, path length, feed, then the machine's axes; mm, degrees,
// seconds. Others stand behind them.

#include <concepts>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/base/sink.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/base/word.hpp>
#include <string>

namespace leadscrew::trace {

/// Which columns a trace has behind those of the words, in this order.
struct MoreColumns {
  bool actual = false;  ///< actual_X, actual_Y, …: where the slides were
  bool power = false;   ///< power: of the laser
};

/// What they hold in the row of a word.
struct BesideWord {
  base::AxisVector actual{};  ///< mm or degrees
  double power = 0;           ///< machine::LaserPower
};

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
