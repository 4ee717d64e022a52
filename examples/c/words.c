/* Words by C: of a part program, or, without one, of three moves. Each line: tick, X, Y, Z. */
#include <leadscrew.h>
#include <stdio.h>

static char text[1 << 20];

static int failed(const leadscrew_error *error) {
  fprintf(stderr, "line %lld: %s [%s]\n", (long long)error->line, error->message, error->code);
  return 1;
}

int main(int argc, char **argv) {
  leadscrew_error error = {.size = sizeof error};
  leadscrew_machine *machine;
  leadscrew_motion *motion;
  if (leadscrew_machine_builtin("mill3", &machine, &error)) return failed(&error);

  if (argc == 2) {
    FILE *file = fopen(argv[1], "rb");
    if (!file) return perror(argv[1]), 1;
    size_t length = fread(text, 1, sizeof text, file);
    fclose(file);
    if (leadscrew_motion_of_program(machine, text, length, NULL, &motion, &error)) return failed(&error);
  } else {
    leadscrew_move moves[] = {
        {.size = sizeof *moves, .kind = LEADSCREW_LINE, .end = {10, 0, 0}, .feed = 50},
        {.size = sizeof *moves, .kind = LEADSCREW_ARC, .end = {10, 10, 0}, .center = {10, 5}, .turns = 1, .feed = 50},
        {.size = sizeof *moves, .kind = LEADSCREW_LINE, .end = {0, 10, 2}, .feed = 50}};
    if (leadscrew_motion_of_moves(machine, NULL, &motion, &error)) return failed(&error);
    for (int i = 0; i < 3; ++i)
      if (leadscrew_motion_push(motion, &moves[i], &error)) return failed(&error);
    leadscrew_motion_finish(motion);
  }

  leadscrew_word words[1000];
  for (size_t count = 1; count > 0;) {
    if (leadscrew_motion_next(motion, words, sizeof *words, 1000, &count, &error)) return failed(&error);
    for (size_t i = 0; i < count; ++i)
      printf("%lld %.17g %.17g %.17g\n", (long long)words[i].tick, words[i].position[0], words[i].position[1],
             words[i].position[2]);
  }
  leadscrew_motion_free(motion);
  leadscrew_machine_free(machine);
  return 0;
}
