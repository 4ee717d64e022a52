#include <filesystem>
#include <leadscrew/files/word_file.hpp>
#include <leadscrew/json/json.hpp>
#include <leadscrew/trace/named_columns.hpp>

namespace leadscrew::files {

std::optional<std::string> side_of(const std::optional<std::string>& trace) {
  return trace && trace::is_nameless(extension(*trace)) ? std::optional(*trace + ".json") : std::nullopt;
}

base::Result<void> WordFile::open(const std::string& path, const std::string& program, const machine::Machine& machine,
                                  trace::MoreColumns columns) {
  const std::string ending = extension(path);
  const auto access = trace::has_header_last(ending) ? OutputFile::Access::rewritable : OutputFile::Access::sequential;
  auto file = OutputFile::create(path, access);
  if (!file) return base::failure(file.error());
  file_ = std::make_unique<OutputFile>(std::move(*file));
  writer_.emplace(ending, file_->sink(), machine.axis_set(), machine.period, columns);
  if (columns.power) laser_.emplace(*machine.laser);
  return write_side(path, program, machine, columns);
}

base::Result<void> WordFile::write_side(const std::string& path, const std::string& program,
                                        const machine::Machine& machine, const trace::MoreColumns& columns) {
  const auto side = side_of(path);
  if (!side) return {};
  auto file = OutputFile::create(*side, OutputFile::Access::sequential);
  if (!file) return base::failure(file.error());
  side_ = std::make_unique<OutputFile>(std::move(*file));
  using json::Json;
  Json named = Json::list();
  for (const trace::NamedColumn& column : trace::named_columns(machine.axis_set(), columns))
    named.push_back(Json::object({{"name", column.name}, {"unit", column.unit}}));
  const Json object = Json::object({{"schema", trace_schema},
                                    {"trace", std::filesystem::path(path).filename().string()},
                                    {"program", program},
                                    {"machine", machine.name},
                                    {"period_s", machine.period.seconds()},
                                    {"columns", std::move(named)}});
  return side_->write(object.written() + "\n");
}

base::Result<void> WordFile::write(const base::Word& word, trace::BesideWord beside) {
  if (!writer_) return {};
  for (; !events_.empty() && events_.front().tick <= word.tick; events_.pop_front()) laser_->observe(events_.front());
  beside.power = laser_ ? laser_->at(word) : 0;
  return writer_->write(word, beside);
}

base::Result<void> WordFile::finish() {
  if (!writer_) return {};
  if (auto finished = writer_->finish(); !finished) return finished;
  const auto header = writer_->header();
  return header ? file_->rewrite_start(*header) : base::Result<void>();
}

base::Result<void> WordFile::publish() {
  if (auto finished = finish(); !finished) return finished;
  return publish_together({file_.get(), side_.get()});
}

}  // namespace leadscrew::files
