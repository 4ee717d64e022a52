#include <leadscrew/trace/word_writer.hpp>

namespace leadscrew::trace {

namespace {

/// Calls the visitor with the row of the ending, or the first.
template <typename Visitor>
void with_format(std::string_view ending, const Visitor& visitor) {
  const bool is_known = std::apply(
      [&](const auto&... format) { return ((format.ending == ending && (visitor(format), true)) || ...); }, formats);
  if (!is_known) visitor(std::get<0>(formats));
}

}  // namespace

std::vector<std::string_view> endings() {
  return std::apply([](const auto&... format) { return std::vector{format.ending...}; }, formats);
}

std::string endings_text() {
  const std::vector<std::string_view> all = endings();
  std::string text(all.front());
  for (std::size_t i = 1; i < all.size(); ++i) text.append(i + 1 < all.size() ? ", " : " or ").append(all[i]);
  return text;
}

bool has_header_last(std::string_view ending) {
  bool is_last = false;
  with_format(ending, [&]<class F>(const F&) { is_last = HeaderLast<typename F::Writer>; });
  return is_last;
}

bool is_nameless(std::string_view ending) {
  bool is = false;
  with_format(ending, [&]<class F>(const F&) { is = Nameless<typename F::Writer>; });
  return is;
}

WordWriter::AnyWriter WordWriter::made(std::string_view ending, const base::ByteSink& sink, base::AxisSet axes,
                                       base::Period period, MoreColumns columns) {
  std::optional<AnyWriter> writer;
  with_format(ending, [&]<class F>(const F&) {
    writer.emplace(std::in_place_type<typename F::Writer>, sink, axes, period, columns);
  });
  return std::move(*writer);
}

WordWriter::WordWriter(std::string_view ending, const base::ByteSink& sink, base::AxisSet axes, base::Period period,
                       MoreColumns columns)
    : writer_(made(ending, sink, axes, period, columns)) {}

std::optional<std::string> WordWriter::header() const {
  return std::visit(
      []<class W>(const W& writer) -> std::optional<std::string> {
        if constexpr (HeaderLast<W>) return writer.header();
        return std::nullopt;
      },
      writer_);
}

}  // namespace leadscrew::trace
