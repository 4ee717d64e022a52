// leadscrew-exchange FORMAT FILE TOLERANCE: the faces of a STEP or IGES file as lines of JSON (face_lines.hpp). `leadscrew
// surfaces` starts it. Status: 0 where the lines are whole, also where they tell a problem of the file.

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <cstdio>
#include <cstdlib>
#include <leadscrew/exchange/face_lines.hpp>
#include <new>

#include "opencascade.hpp"

namespace {

using namespace leadscrew::exchange;

constexpr rlim_t most_memory = rlim_t{16} << 30;  // bytes

/// What OpenCASCADE prints is for nobody: the answer has a descriptor of its own.
std::FILE* answer_alone() {
  std::FILE* answer = ::fdopen(::dup(STDOUT_FILENO), "w");
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  Message::DefaultMessenger()->ChangePrinters().Clear();
  return answer;
}

void bound_resources() {
  const rlimit memory = {most_memory, most_memory}, none = {0, 0};
  ::setrlimit(RLIMIT_AS, &memory);
  ::setrlimit(RLIMIT_CORE, &none);
}

void say(std::FILE* answer, const std::string& line) {
  std::fwrite(line.data(), 1, line.size(), answer);
}

void tell_faces(std::FILE* answer, const std::string& format, const std::string& file, double tolerance) {
  const Part part = part_of(format, file);
  say(answer, line_of_header(format, part.unit));
  for_each_face(part.shape, tolerance, [answer](const Face& face) { say(answer, line_of(face)); });
  say(answer, line_of_end());
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) {
    std::fputs("leadscrew surfaces starts this program\n", stderr);
    return 2;
  }
  bound_resources();
  std::FILE* answer = answer_alone();
  const char* const hint = "is the file whole? Export it anew, or in the other format";
  try {
    tell_faces(answer, words[1], words[2], std::strtod(words[3], nullptr));
  } catch (const Unreadable& problem) {
    say(answer, line_of_problem(problem.code, problem.what(), problem.hint));
  } catch (const Standard_Failure& failure) {
    say(answer, line_of_problem("exchange-read",
                                std::string("OpenCASCADE cannot read it: ") + failure.GetMessageString(), hint));
  } catch (const std::bad_alloc&) {
    say(answer, line_of_problem("exchange-read", "takes more memory than there is",
                                "write the faces that are machined into a file of their own"));
  } catch (const std::exception& failure) {
    say(answer, line_of_problem("exchange-read", std::string("OpenCASCADE cannot read it: ") + failure.what(), hint));
  }
  return std::fclose(answer) == 0 ? 0 : 1;
}
