// Circular interpolation by the improved method of least error (eqs. 17 to 22): the axis that is faster here steps at
// every clock; the other one steps where the middle of its two candidates lies on the wrong side of the circle. With s
// for the |coordinate| that shrinks, g for the one that grows:
//
//   Z faster, or what grows is:  d = 4s − 8g − 5 − 4F,  both step where d ≤ 0      (g ≤ s)
//   what shrinks is faster:      d = 8s − 4g − 5 − 4F,  both step where d ≥ 0      (g > s; eq. 19 has it as 8y − 4x)

module improved_minimum_error #(
    parameter int WIDTH = 16,           // of the signed coordinates, bits: 4 … 31
    parameter bit FIRST_QUADRANT = 1'b0  // only 0 ≤ x, 0 ≤ z, counterclockwise; nothing is refused: the paper's size
) (
    input  logic                    clk,
    input  logic                    rst,        // synchronous
    input  logic signed [WIDTH-1:0] Start_X0,   // BLU, about the centre of the circle
    input  logic signed [WIDTH-1:0] Start_Z0,
    input  logic signed [WIDTH-1:0] End_X1,     // the start again: a full circle
    input  logic signed [WIDTH-1:0] End_Z1,
    input  logic                    Cw,         // clockwise, seen with X to the right and Z up
    input  logic                    Syn,        // takes all these at this clock and starts
    output logic                    X_Pwm_Out,  // high for one clock: X has stepped
    output logic                    Z_Pwm_Out,
    output logic                    X_Dir,      // with the pulse: 1 where x has increased
    output logic                    Z_Dir,
    output logic                    Busy,       // from Syn to the last pulse
    output logic                    Err,        // what Syn took is no arc (arc_entry.sv); until the next Syn
    output logic signed [WIDTH-1:0] Val_x,      // where it is
    output logic signed [WIDTH-1:0] Val_z,
    output logic signed [WIDTH+2:0] Val_f,      // F = x² + z² − R²
    output logic signed [WIDTH+4:0] Val_d       // 4(d1 − d2) of eq. 19, of the circle less that of the middle
);
  logic signed [WIDTH+2:0] by_x, by_z;
  logic signed [WIDTH+4:0] by_shrinking, by_growing, of_both, of_faster;
  logic x_shrinks, growing_is_faster, both, step_x, step_z;

  // 1 − 2s and 1 + 2g
  assign by_shrinking = x_shrinks ? (WIDTH + 5)'(by_x) : (WIDTH + 5)'(by_z);
  assign by_growing = x_shrinks ? (WIDTH + 5)'(by_z) : (WIDTH + 5)'(by_x);
  assign of_both = by_shrinking + by_growing;  // 2(g − s) + 2
  assign growing_is_faster = of_both <= 2;
  assign of_faster = growing_is_faster ? by_growing : by_shrinking;
  assign Val_d = 1 - 2 * (of_both + of_faster + 2 * (WIDTH + 5)'(Val_f));
  assign both = growing_is_faster ? Val_d <= 0 : Val_d >= 0;
  assign step_x = both || (growing_is_faster ^ x_shrinks);
  assign step_z = both || !(growing_is_faster ^ x_shrinks);

  arc_search #(.WIDTH(WIDTH), .FIRST_QUADRANT(FIRST_QUADRANT)) search (
      .clk(clk), .rst(rst), .start_x(Start_X0), .start_z(Start_Z0), .end_x(End_X1), .end_z(End_Z1), .clockwise(Cw),
      .syn(Syn), .step_x(step_x), .step_z(step_z), .x(Val_x), .z(Val_z), .f(Val_f), .by_x(by_x), .by_z(by_z),
      .x_shrinks(x_shrinks), .x_pulse(X_Pwm_Out), .z_pulse(Z_Pwm_Out), .x_up(X_Dir), .z_up(Z_Dir), .busy(Busy),
      .refused(Err));
endmodule
