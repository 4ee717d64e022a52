#include <cmath>
#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/shared_arguments.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/results/surface_list.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::string_view surfaces_examples =
    "Examples:\n"
    "  leadscrew surfaces part.step                         which faces there are\n"
    "  leadscrew surfaces part.step --face 3 > face.ngc     face 3 as the surface D3, blocks of G6.4\n"
    "  leadscrew surfaces part.iges --all --output faces.ngc\n"
    "\n"
    "A face is taken whole: one whose outline follows the lines of its parameters, or a plane one with four\n"
    "corners. Its side Su x Sv, R1 of G6.5, is that outside the part.\n"
    "STEP and IGES are read by builds with LEADSCREW_EXCHANGE alone.\n";

Parsed<std::vector<std::size_t>> parse_faces(std::string_view text) {
  constexpr double most = 1e9;
  const auto numbers = parse_numbers(text);
  if (!numbers) return tl::unexpected(numbers.error());
  std::vector<std::size_t> faces;
  for (const double number : *numbers) {
    if (!(number >= 1) || number > most || number != std::floor(number)) return wrong("faces count from 1");
    faces.push_back(static_cast<std::size_t>(number));
  }
  return faces;
}

/// Says why faces that are asked for are not to be had; of all faces, which are left out.
void tell_refusals(const SurfacesArguments& asked, const exchange::Faces& faces, DiagnosticLog& log) {
  bool any = false;
  for (const exchange::Face& face : faces.faces) {
    any = any || !face.refusal;
    if (asked.all && face.refusal) log.add(results::refusal_of(asked.file, face, base::Severity::warning));
  }
  for (const std::size_t number : asked.faces) {
    if (number > faces.faces.size()) {
      log.add(base::problem("face-number", fmt::format("{} has no face {}", asked.file, number),
                            fmt::format("its faces are 1 to {}", faces.faces.size())));
    } else if (const exchange::Face& face = faces.faces[number - 1]; face.refusal) {
      log.add(results::refusal_of(asked.file, face, base::Severity::error));
    }
  }
  if (asked.all && !any)
    log.add(base::problem("exchange-faces", fmt::format("no face of {} can be machined", asked.file), ""));
}

base::Result<void> write_blocks(const std::string& path, std::string_view text) {
  auto file = files::OutputFile::create(path, files::OutputFile::Access::sequential);
  if (!file) return base::failure(file.error());
  if (auto written = file->write(text); !written) return written;
  return files::publish_together({&*file});
}

}  // namespace

void describe_surfaces(Command& command, Arguments& arguments) {
  SurfacesArguments& asked = arguments.surfaces;
  command.word("FILE", "STEP or IGES file", asked.file, file({".step", ".stp", ".iges", ".igs"}));
  command.value("--face", "N,...", "Write these faces as blocks, in place of the table", asked.faces, parse_faces);
  command.flag("--all", "Write every face that can be machined", asked.all);
  command.value("--approximate", "MM", "Take surfaces within so many mm that cannot be converted exactly",
                asked.approximate, [](std::string_view text) -> Parsed<double> {
                  const auto number = parse_number(text);
                  if (!number || !(*number >= 1e-6) || *number > 1)
                    return wrong("is no tolerance from 0.000001 to 1 mm");
                  return *number;
                });
  command.output("--output", "FILE.ngc", "Write the blocks there, in place of standard output", asked.output,
                 {".ngc", ".nc"});
  add_output(command, arguments);
  command.check([&asked, &arguments]() -> Parsed<void> {
    const bool writes = asked.all || !asked.faces.empty();
    if (asked.all && !asked.faces.empty()) return wrong("--face and --all: one of them");
    if (asked.output && !writes) return wrong("--output needs --face or --all");
    if (arguments.json && writes && !asked.output) return wrong("--json needs --output for the blocks");
    return {};
  });
  command.help(std::string(surfaces_examples));
}

Status surfaces(const Arguments& arguments, Console& console) {
  const SurfacesArguments& asked = arguments.surfaces;
  DiagnosticLog log(console);
  const auto faces = exchange::read_faces(exchange::reading_program(), asked.file, asked.approximate);
  if (!faces) log.add(faces.error());
  if (!faces && faces.error().code == "exchange-not-built") return Status::usage;
  const bool writes = asked.all || !asked.faces.empty();
  if (faces && writes) tell_refusals(asked, *faces, log);
  std::string text;
  std::vector<std::size_t> written;
  if (faces && writes && log.errors() == 0) {
    text = results::surface_blocks(asked.file, *faces, asked.faces);
    for (const exchange::Face& face : faces->faces) {
      const bool is_asked = asked.all || std::ranges::find(asked.faces, face.number) != asked.faces.end();
      if (is_asked && !face.refusal) written.push_back(face.number);
    }
    if (asked.output) {
      if (auto done = write_blocks(*asked.output, text); !done) log.add(done.error());
      text.clear();
    }
  } else if (faces && !writes && !arguments.quiet) {
    text = results::surfaces_text(asked.file, *faces, console.output_style());
  }
  if (log.status() == Status::interrupted) return log.status();
  if (arguments.json) text = results::surfaces_json(asked.file, faces ? &*faces : nullptr, written, log.all());
  return worse(log.status(), write_output(console, text));
}

}  // namespace leadscrew::cli
