#pragma once
// Words in the format that a file's ending names.

#include <leadscrew/trace/formats.hpp>
#include <optional>
#include <variant>
#include <vector>

namespace leadscrew::trace {

/// ".csv" and all others, as formats.hpp has them.
std::vector<std::string_view> endings();
/// ".csv or .npy", for people.
std::string endings_text();

/// Will header() have to be written over the beginning of such a file?
bool has_header_last(std::string_view ending);

/// Does a file of such an ending not say what its columns are?
bool is_nameless(std::string_view ending);

class WordWriter {
 public:
  /// `ending`: of the file's name, in small letters, with its point.
  WordWriter(std::string_view ending, const base::ByteSink& sink, base::AxisSet axes, base::Period period,
             MoreColumns columns = {});

  base::Result<void> write(const base::Word& word, const BesideWord& beside = {}) {
    return std::visit([&](auto& writer) { return writer.write(word, beside); }, writer_);
  }
  base::Result<void> finish() {
    return std::visit([](auto& writer) { return writer.finish(); }, writer_);
  }
  /// Of a format whose header comes last (writer.hpp), once it is finished.
  std::optional<std::string> header() const;

 private:
  template <class>
  struct Writers;
  template <class... Formats>
  struct Writers<std::tuple<Formats...>> {
    using Any = std::variant<typename Formats::Writer...>;
  };
  using AnyWriter = Writers<std::remove_const_t<decltype(formats)>>::Any;

  static AnyWriter made(std::string_view ending, const base::ByteSink& sink, base::AxisSet axes, base::Period period,
                        MoreColumns columns);

  AnyWriter writer_;
};

}  // namespace leadscrew::trace
