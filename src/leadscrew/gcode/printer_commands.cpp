#include <array>
#include <charconv>
#include <leadscrew/gcode/expression.hpp>
#include <leadscrew/gcode/printer_commands.hpp>

namespace leadscrew::gcode {

namespace {

constexpr bool hardware = true, quiet = false;

constexpr std::array<PrinterCommand, 53> all_printer_commands = {{
    {'G', 10, 11, hardware, "retracts or recovers material"},
    {'G', 12, 12, hardware, "cleans the nozzle"},
    {'G', 26, 27, hardware, "mesh pattern, parking of the head"},
    {'G', 29, 29, hardware, "levelling of the bed"},
    {'G', 34, 35, hardware, "alignment of the gantry"},
    {'G', 42, 42, hardware, "move to a point of the bed's mesh"},
    {'G', 60, 60, quiet, "keeps the place that G61 goes back to"},
    {'G', 76, 77, hardware, "calibration by temperature"},
    {'G', 425, 425, hardware, "calibration of backlash"},
    {'M', 10, 11, hardware, "vacuum or blower"},
    {'M', 16, 16, quiet, "name of the printer that the program is for"},
    {'M', 17, 18, hardware, "motors on or off"},
    {'M', 20, 29, hardware, "memory card"},
    {'M', 31, 39, hardware, "memory card"},
    {'M', 42, 43, hardware, "pins of the controller"},
    {'M', 48, 48, hardware, "accuracy of the probe"},
    {'M', 73, 73, quiet, "progress of a print"},
    {'M', 75, 78, quiet, "time of a print"},
    {'M', 80, 81, hardware, "power supply"},
    {'M', 82, 83, quiet, "material in absolute or relative lengths"},
    {'M', 84, 87, hardware, "motors or heaters off"},
    {'M', 92, 92, hardware, "steps of a millimetre"},
    {'M', 100, 102, quiet, "memory, or settings of the bed"},
    {'M', 104, 104, hardware, "temperature of the hot end"},
    {'M', 105, 105, quiet, "asks for temperatures"},
    {'M', 106, 107, hardware, "fan"},
    {'M', 108, 108, quiet, "breaks off waiting"},
    {'M', 109, 109, hardware, "waits for the temperature of the hot end"},
    {'M', 110, 110, quiet, "number of the line"},
    {'M', 111, 111, quiet, "what is told for finding faults"},
    {'M', 113, 115, quiet, "asks the controller"},
    {'M', 117, 119, quiet, "message, or asks for switches"},
    {'M', 120, 121, hardware, "limit switches on or off"},
    {'M', 122, 123, quiet, "asks for drivers or fans"},
    {'M', 125, 125, hardware, "parks the head"},
    {'M', 126, 129, hardware, "valves"},
    {'M', 140, 141, hardware, "temperature of the bed or chamber"},
    {'M', 145, 145, hardware, "temperatures of a material"},
    {'M', 149, 155, hardware, "temperatures and lights"},
    {'M', 160, 166, hardware, "mixture of materials"},
    {'M', 190, 193, hardware, "waits for the temperature of the bed, the chamber or the cooler"},
    {'M', 200, 200, hardware, "diameter of the material"},
    {'M', 201, 205, hardware, "velocity, acceleration and jerk: those of the machine file hold"},
    {'M', 206, 218, hardware, "offsets of the controller"},
    {'M', 220, 221, hardware, "override of feed or flow"},
    {'M', 226, 226, hardware, "waits for a pin of the controller"},
    {'M', 240, 290, hardware, "camera, servo, sound of the controller"},
    {'M', 300, 399, hardware, "sound and settings of the controller"},
    {'M', 401, 409, hardware, "probe and sensors"},
    {'M', 410, 599, hardware, "settings of the controller"},
    {'M', 600, 799, hardware, "change of material"},
    {'M', 800, 999, hardware, "settings of the controller"},
    {'M', 7219, 7219, hardware, "display of lights"},
}};

struct FirstWord {
  const char* begin = nullptr;  ///< of its letter
  const char* end = nullptr;    ///< behind its number
  char letter = 0;
  int number = -1;
};

const char* behind_blanks(const char* p) {
  skip_blanks(p);
  return p;
}

// The word that says what the line commands, behind its number.
FirstWord first_word(const char* p) {
  p = behind_blanks(p);
  if (upper(*p) == 'N') {
    const char* q = behind_blanks(p + 1);
    while (is_digit(*q)) ++q;
    p = behind_blanks(q);
  }
  FirstWord word{p, p, upper(*p), -1};
  if (word.letter != 'G' && word.letter != 'M') return word;
  const char* const digits = behind_blanks(p + 1);
  const char* end = digits;
  while (is_digit(*end) && end - digits < 6) ++end;
  std::from_chars(digits, end, word.number);
  word.end = end;
  return word;
}

}  // namespace

std::span<const PrinterCommand> printer_commands() {
  return all_printer_commands;
}

bool PrinterCommands::take(TextLine& line) {
  const FirstWord word = first_word(line.text);
  if (word.number < 0) return false;
  for (const PrinterCommand& each : all_printer_commands) {
    if (each.letter == word.letter && each.first <= word.number && word.number <= each.last) {
      return pass_over(each, word.number, word.begin);
    }
  }
  const bool waits = word.letter == 'M' && word.number == 400;  // for the moves before it
  if (waits) {
    give(line, "G4P0");
  } else if (word.letter == 'M' && word.number <= 1) {
    give(line, word.number == 0 ? "M0" : "M1");
  } else if (word.letter == 'M' && word.number == 112) {
    give(line, "M2");  // everything stops
  } else if (word.letter == 'G' && word.number == 28) {
    std::string home = "G28";
    for (const char* p = word.end; *p != '\n' && *p != ';' && *p != '*'; ++p) {
      const char letter = upper(*p);
      if ('X' <= letter && letter <= 'Z') home += std::string(1, letter) + "0";
    }
    give(line, home);
  }
  return false;
}

bool PrinterCommands::pass_over(const PrinterCommand& command, int number, const char* at) {
  if (command.is_hardware && told_.emplace(command.letter, number).second) {
    reporter_.warning("printer-command", reporter_.column(at),
                      command.letter + std::to_string(number) + " (" + command.summary + ") is passed over",
                      "a machine tool has no such thing");
  }
  return true;
}

void PrinterCommands::give(TextLine& line, std::string_view text) {
  copy_.assign(text);
  copy_ += '\n';
  line.begin = line.text = copy_.data();
  line.end = line.begin + text.size();
  reporter_.begin(line);
}

}  // namespace leadscrew::gcode
