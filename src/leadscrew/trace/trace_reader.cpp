#include <leadscrew/trace/formats.hpp>
#include <leadscrew/trace/trace_reader.hpp>
#include <variant>

namespace leadscrew::trace {

namespace {

template <class>
struct RowsOf;
template <class... Formats>
struct RowsOf<std::tuple<Formats...>> {
  using Any = std::variant<typename Formats::Rows...>;
};
using AnyRows = RowsOf<std::remove_const_t<decltype(formats)>>::Any;

template <class R>
base::Result<AnyRows> opened(Input& input, std::string_view file, base::AxisSet axes) {
  return R::open(input, std::string(file), axes).transform([](R&& rows) { return AnyRows(std::move(rows)); });
}

}  // namespace

class TraceReader::Implementation {
 public:
  Implementation(Input input, AnyRows rows) : input_(std::move(input)), rows_(std::move(rows)) {}

  base::Result<std::optional<TraceRow>> next() {
    return std::visit([&](auto& rows) { return rows.next(input_); }, rows_);
  }
  base::AxisSet axes() const {
    return std::visit([](const auto& rows) { return rows.axes(); }, rows_);
  }

 private:
  Input input_;
  AnyRows rows_;
};

base::Result<TraceReader> TraceReader::open(base::ByteSource source, std::string_view file, base::AxisSet axes) {
  Input input(std::move(source));
  const auto start = input.peek(start_bytes);
  if (!start) return base::failure(start.error());
  std::optional<base::Result<AnyRows>> rows;
  std::apply(
      [&]<class... F>(const F&...) {
        static_cast<void>((
            (F::Rows::recognises(*start) && (rows.emplace(opened<typename F::Rows>(input, file, axes)), true)) || ...));
      },
      formats);
  if (!rows) rows.emplace(opened<std::variant_alternative_t<0, AnyRows>>(input, file, axes));
  if (!*rows) return base::failure(rows->error());
  return TraceReader(std::make_unique<Implementation>(std::move(input), std::move(**rows)));
}

base::Result<std::optional<TraceRow>> TraceReader::next() {
  return implementation_->next();
}
base::AxisSet TraceReader::axes() const {
  return implementation_->axes();
}

TraceReader::TraceReader(std::unique_ptr<Implementation> implementation) : implementation_(std::move(implementation)) {}
TraceReader::~TraceReader() = default;
TraceReader::TraceReader(TraceReader&&) noexcept = default;
TraceReader& TraceReader::operator=(TraceReader&&) noexcept = default;

}  // namespace leadscrew::trace
