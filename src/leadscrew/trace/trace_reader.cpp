#include <leadscrew/trace/csv_rows.hpp>
#include <leadscrew/trace/npy_rows.hpp>
#include <leadscrew/trace/words.hpp>

#include <variant>

namespace leadscrew::trace {

class TraceReader::Implementation {
 public:
  Implementation(Input input, std::variant<CsvRows, NpyRows> rows) : input_(std::move(input)), rows_(std::move(rows)) {}

  base::Result<std::optional<Row>> next() {
    if (CsvRows* rows = std::get_if<CsvRows>(&rows_)) return rows->next(input_);
    return std::get_if<NpyRows>(&rows_)->next(input_);
  }

  base::AxisSet axes() const {
    if (const CsvRows* rows = std::get_if<CsvRows>(&rows_)) return rows->axes();
    return std::get_if<NpyRows>(&rows_)->axes();
  }

 private:
  Input input_;
  std::variant<CsvRows, NpyRows> rows_;
};

base::Result<TraceReader> TraceReader::open(base::ByteSource source, std::string_view file, base::AxisSet axes) {
  Input input(std::move(source));
  const auto start = input.peek(NpyRows::magic.size());
  if (!start) return base::failure(start.error());
  if (*start == NpyRows::magic) {
    auto rows = NpyRows::open(input, std::string(file), axes);
    if (!rows) return base::failure(rows.error());
    return TraceReader(std::make_unique<Implementation>(std::move(input), std::move(*rows)));
  }
  auto rows = CsvRows::open(input, std::string(file));
  if (!rows) return base::failure(rows.error());
  return TraceReader(std::make_unique<Implementation>(std::move(input), std::move(*rows)));
}

base::Result<std::optional<Row>> TraceReader::next() {
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
