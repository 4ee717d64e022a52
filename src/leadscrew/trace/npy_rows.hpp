#pragma once
// Rows of a NumPy array file: what NpyWriter writes, and one-dimensional structured arrays of other programs.

#include <leadscrew/trace/columns.hpp>
#include <leadscrew/trace/rows.hpp>

namespace leadscrew::trace {

class NpyRows {
 public:
  static bool recognises(std::string_view start) { return start.starts_with("\x93NUMPY"); }
  /// Reads the header. `axes`: of the machine, for arrays whose columns have no names.
  static base::Result<NpyRows> open(Input& input, std::string file, base::AxisSet axes);

  base::Result<std::optional<TraceRow>> next(Input& input);
  base::AxisSet axes() const { return axes_; }

 private:
  enum class Type : std::uint8_t { float64, int64 };
  struct Field {
    std::string name;
    Type type = Type::float64;
    Column column;
  };

  explicit NpyRows(std::string file) : file_(std::move(file)) {}

  base::Result<void> read_header(std::string_view text, base::AxisSet machine_axes);
  base::Result<void> take_plain_columns(std::int64_t columns, base::AxisSet machine_axes);
  base::Result<void> take_named_columns();
  base::Result<double> value(const Field& field, const char* bytes) const;
  base::Diagnostic wrong(std::string_view code, std::string message, std::string hint) const;

  std::string file_;
  std::vector<Field> fields_;
  std::optional<std::size_t> feed_column_;
  std::int64_t rows_ = 0;
  std::int64_t row_ = 0;  ///< the next one, counted from 0
  base::AxisSet axes_;
};
static_assert(Rows<NpyRows>);

}  // namespace leadscrew::trace
