#pragma once
// What a format of words has to offer.
//
// Columns are `t line s feed X Y Z …`: seconds, source line, path length, feed, then the machine's axes; mm, degrees,
// seconds.

#include <concepts>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/base/sink.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/base/word.hpp>
#include <string>

namespace leadscrew::trace {

/// What the rows of a trace hold.
enum class TraceKind : std::uint8_t {
  words,     ///< where the axes were to be
  followed,  ///< and where their slides were: columns actual_X, actual_Y, … after those of the words
};

/// Opens a trace by its constructor, takes a word a row, and finishes with what is still gathered. `actual`: of
/// TraceKind::followed, mm or degrees. Once the sink has failed, every later call fails with the same diagnostic.
template <class T>
concept Writer = std::constructible_from<T, base::ByteSink, base::AxisSet, base::Period, TraceKind> &&
                 requires(T writer, const base::Word& word, const base::AxisVector& actual) {
                   { writer.write(word, actual) } -> std::same_as<base::Result<void>>;
                   { writer.finish() } -> std::same_as<base::Result<void>>;
                 };

/// Its header is complete only at the end: when finish() has succeeded, the caller writes header() over the first
/// header().size() bytes of the file.
template <class T>
concept HeaderLast = Writer<T> && requires(const T writer) {
  { writer.header() } -> std::same_as<std::string>;
};

}  // namespace leadscrew::trace
