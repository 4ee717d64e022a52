#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/pipeline/path_survey.hpp>
#include <leadscrew/pipeline/whole_reading.hpp>
#include <leadscrew/sweep/archive.hpp>
#include <leadscrew/sweep/judged_run.hpp>
#include <leadscrew/sweep/result.hpp>

namespace leadscrew::sweep {

namespace {

constexpr std::array<std::string_view, 5> program_endings = {".ngc", ".nc", ".tap", ".gcode", ".cnc"};

/// Of a program that has been read whole: its bytes, and its subprograms' by their names.
base::Result<Key> content_of(const files::InputFile& file) {
  KeyMaker all;
  std::vector<const files::InputFile*> texts = file.subprograms();
  texts.insert(texts.begin(), &file);
  for (const files::InputFile* text : texts) {
    KeyMaker bytes;
    if (text != &file) all.add(std::filesystem::path(text->name()).filename().string());
    const base::ByteSource source = text->source();
    std::vector<char> buffer(1 << 16);
    while (true) {
      const auto count = source(buffer);
      if (!count) return base::failure(count.error());
      if (*count == 0) break;
      bytes.add_more({buffer.data(), *count});
    }
    all.add(text_of(bytes.key()));
  }
  return all.key();
}

/// A program that is open, and how it is read on a machine.
struct OpenProgram {
  files::InputFile file;
  machine::Machine machine;
  const ArchiveSetup& setup;

  gcode::ReaderOptions options() const {
    gcode::ReaderOptions options;
    options.file = file.name();
    options.opener = file.opener(setup.subprograms);
    options.dialect = machine.dialect;
    return options;
  }
};

machine::Machine machine_of(const ArchiveSetup& setup, std::size_t number) {
  machine::Machine machine = setup.machines[number].machine;
  if (setup.dialect) machine.dialect = *setup.dialect;
  return machine;
}

/// What reading a program whole finds.
struct WholeReading {
  pipeline::ReadProgram read;
  std::optional<base::Diagnostic> first_error;
  std::int64_t errors = 0;
  double tolerance = 0;  ///< mm, the largest of its moves
};

base::Result<WholeReading> read(const OpenProgram& program, const gcode::ReaderOptions& options,
                                pipeline::Survey* survey) {
  WholeReading whole;
  gcode::Reader reader(program.file.source(), program.machine, program.setup.tools, options,
                       [&](const base::Diagnostic& problem) {
                         if (problem.severity != base::Severity::error) return;
                         if (whole.errors++ == 0) whole.first_error = problem;
                       });
  whole.read = pipeline::read_whole(
      reader, {.survey = survey,
               .is_sound = [&] { return whole.errors == 0; },
               .see = [&](const gcode::Move& move) { whole.tolerance = std::max(whole.tolerance, move.tolerance); },
               .goes_on = [] { return !files::interrupted(); }});
  if (files::interrupted()) return base::failure(files::interruption());
  if (!reader.source_failure()) return whole;
  if (reader.source_failure()->code == "program-changed") return base::failure(*reader.source_failure());
  whole.first_error = *reader.source_failure();
  ++whole.errors;
  return whole;
}

base::Diagnostic changed(const std::string& path) {
  return {base::Severity::error,
          "program-changed",
          "is another program than when the sweep began",
          "start the sweep again: it takes the program as it is then",
          {.file = path},
          {}};
}

bool is_program(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::ranges::find(program_endings, ending) != program_endings.end();
}

base::Result<std::vector<std::string>> programs_of_folder(const std::string& folder) {
  std::vector<std::string> found;
  std::error_code error;
  std::filesystem::recursive_directory_iterator entries(folder, error);
  for (; !error && entries != std::filesystem::recursive_directory_iterator(); entries.increment(error)) {
    if (!entries->is_directory() && is_program(entries->path())) found.push_back(entries->path().string());
  }
  if (error) return base::failure(files::system_failure("io-open", "cannot open", folder, error.value()));
  std::ranges::sort(found);
  if (found.empty())
    return base::failure({base::Severity::error,
                          "no-programs",
                          "the folder has no part programs",
                          fmt::format("files that end in {}", fmt::join(program_endings, ", ")),
                          {.file = folder},
                          {}});
  return found;
}

}  // namespace

base::Result<std::vector<std::string>> programs_in(const std::vector<std::string>& paths) {
  std::vector<std::string> all;
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(path, ignored)) {
      all.push_back(path);
      continue;
    }
    const auto found = programs_of_folder(path);
    if (!found) return found;
    all.insert(all.end(), found->begin(), found->end());
  }
  return all;
}

base::Result<SurveyedProgram> survey(const ArchiveSetup& setup, std::size_t number) {
  SurveyedProgram program{.path = setup.programs[number]};
  KeyMaker of_path;
  of_path.add(program.path);
  program.content = of_path.key();
  auto file = files::InputFile::open(program.path);
  if (!file && files::interrupted()) return base::failure(files::interruption());
  if (!file) return program;
  const OpenProgram open{std::move(*file), machine_of(setup, 0), setup};
  pipeline::QuickSurvey quick(open.machine, {});
  const auto whole = read(open, open.options(), &quick);
  if (!whole && files::interrupted()) return base::failure(whole.error());
  if (!whole) return program;
  const auto content = content_of(open.file);
  if (!content) return program;
  program.content = *content;
  program.is_readable = true;
  if (whole->errors == 0) quick.finish();
  program.bound_s = quick.bound_seconds();
  program.moves = whole->read.moves;
  return program;
}

Archive::Archive(const ArchiveSetup& setup, std::vector<SurveyedProgram> programs)
    : setup_(setup), programs_(std::move(programs)) {
  for (const NamedMachine& machine : setup.machines) {
    KeyMaker key;
    for (const std::string_view part :
         {std::string_view(LEADSCREW_VERSION), std::string_view(machine.text), std::string_view(setup.tools_text)})
      key.add(part);
    key.add(setup.dialect ? machine::dialect_names[static_cast<std::size_t>(*setup.dialect)] : "");
    of_machines_.push_back(text_of(key.key()));
  }
}

std::int64_t Archive::count() const {
  return static_cast<std::int64_t>(programs_.size() * setup_.machines.size() * setup_.parameters.size());
}

Archive::Place Archive::place_of(std::int64_t task) const {
  const auto number = static_cast<std::size_t>(task);
  const std::size_t parameters = setup_.parameters.size(), machines = setup_.machines.size();
  return {number / parameters / machines, number / parameters % machines, number % parameters};
}

Key Archive::key(std::int64_t task) const {
  const Place at = place_of(task);
  Parameters parameters = setup_.parameters[at.parameters];
  // What a machine lacks changes nothing of it.
  const auto& changed = parameters.changed_limit;
  if (changed && !setup_.machines[at.machine].machine.has(changed->axis)) parameters.changed_limit.reset();
  KeyMaker key;
  key.add(text_of(programs_[at.program].content));
  key.add(of_machines_[at.machine]);
  json::Json all = json::Json::object();
  for (auto& [name, value] : members_of(parameters)) all[name] = value;
  key.add(all.written_in_line());
  return key.key();
}

double Archive::cost(std::int64_t task) const {
  // Of the computer: a move is planned in some 50 µs, a word made and judged in some 3 µs.
  constexpr double of_move = 50e-6, of_word = 3e-6;
  const Place at = place_of(task);
  const SurveyedProgram& program = programs_[at.program];
  const base::Period period =
      setup_.parameters[at.parameters].period.value_or(setup_.machines[at.machine].machine.period);
  return of_move * static_cast<double>(program.moves) + of_word * program.bound_s / period.seconds();
}

std::vector<json::Json::Member> Archive::place(std::int64_t task) const {
  const Place at = place_of(task);
  std::vector<json::Json::Member> members = {
      {"task", task}, {"program", programs_[at.program].path}, {"machine", setup_.machines[at.machine].path}};
  for (auto& member : members_of(setup_.parameters[at.parameters])) members.push_back(std::move(member));
  return members;
}

base::Result<json::Json> Archive::result(std::int64_t task) {
  const Place at = place_of(task);
  const SurveyedProgram& program = programs_[at.program];
  const Parameters& parameters = setup_.parameters[at.parameters];
  auto file = files::InputFile::open(program.path);
  if (files::interrupted()) return base::failure(files::interruption());
  if (!file && program.is_readable) return base::failure(changed(program.path));
  if (!file) return json_of(file.error(), 1);
  const OpenProgram open{std::move(*file), parameters.applied_to(machine_of(setup_, at.machine)), setup_};
  gcode::ReaderOptions options = open.options();
  options.tolerance = parameters.tolerance;
  options.surface_drafts = gcode::new_surface_drafts();
  const auto whole = read(open, options, nullptr);
  if (!whole) return base::failure(whole.error());
  const auto content = content_of(open.file);
  if (program.is_readable != content.has_value() || (content && *content != program.content))
    return base::failure(changed(program.path));
  if (whole->errors > 0) return json_of(*whole->first_error, whole->errors);
  if (parameters.tolerance_factor != 1) options.tolerance = whole->tolerance * parameters.tolerance_factor;
  const auto run = run_judged({.machine = open.machine,
                               .tools = setup_.tools,
                               .options = options,
                               .source = [&] { return open.file.source(); },
                               .override_factor = parameters.override_factor,
                               .unchanged = [&] { return open.file.unchanged(); }});
  if (run) return json_of(*run);
  const std::string_view code = run.error().code;
  if (code == "interrupted" || code == "program-changed") return base::failure(run.error());
  return json_of(run.error(), 1);
}

}  // namespace leadscrew::sweep
