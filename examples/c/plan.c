/* Planned at once by C: how long three moves take, and where X and Y are then and then, and how fast. */
#include <leadscrew.h>
#include <stdio.h>

int main(void) {
  leadscrew_error error = {.size = sizeof error};
  leadscrew_machine *machine;
  leadscrew_motion *motion;
  leadscrew_trajectory *trajectory;
  leadscrew_move moves[] = {
      {.size = sizeof *moves, .kind = LEADSCREW_LINE, .end = {10, 0, 0}, .feed = 50},
      {.size = sizeof *moves, .kind = LEADSCREW_ARC, .end = {10, 10, 0}, .center = {10, 5}, .turns = 1, .feed = 50},
      {.size = sizeof *moves, .kind = LEADSCREW_LINE, .end = {0, 10, 2}, .feed = 50}};
  int code = leadscrew_machine_builtin("mill3", &machine, &error);
  if (!code) code = leadscrew_motion_of_moves(machine, NULL, &motion, &error);
  for (int i = 0; i < 3 && !code; ++i) code = leadscrew_motion_push(motion, &moves[i], &error);
  if (!code) code = leadscrew_motion_plan(motion, &trajectory, &error);
  if (code) return fprintf(stderr, "%s [%s]\n", error.message, error.code), 1;

  const double duration = leadscrew_trajectory_duration(trajectory);
  for (int i = 0; i <= 10; ++i) {
    leadscrew_state at = {.size = sizeof at};
    leadscrew_trajectory_at(trajectory, duration * i / 10, &at, NULL);
    printf("%6.3f s  X %7.3f mm %8.3f mm/s %9.2f mm/s2  Y %7.3f mm %8.3f mm/s %9.2f mm/s2\n", duration * i / 10,
           at.position[0], at.velocity[0], at.acceleration[0], at.position[1], at.velocity[1], at.acceleration[1]);
  }
  printf("%.3f s\n", duration);
  leadscrew_trajectory_free(trajectory);
  leadscrew_motion_free(motion);
  leadscrew_machine_free(machine);
  return 0;
}
