// Circular interpolation by least error (the paper's "min-error", eqs. 9 to 16): of the three steps that the quadrant allows,
// both axes, Z alone, X alone, the one that leads nearest to the circle. The paper compares n; |n| is meant.

module minimum_error #(
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
    output logic signed [WIDTH+2:0] Val_n1,     // F after a step of both axes
    output logic signed [WIDTH+2:0] Val_n2,     // after one of Z alone
    output logic signed [WIDTH+2:0] Val_n3      // after one of X alone
);
  logic signed [WIDTH+2:0] by_x, by_z;
  logic [WIDTH+2:0] size_1, size_2, size_3;
  logic x_shrinks, step_x, step_z;

  assign Val_n1 = Val_f + by_x + by_z;
  assign Val_n2 = Val_f + by_z;
  assign Val_n3 = Val_f + by_x;
  assign size_1 = Val_n1[WIDTH+2] ? -Val_n1 : Val_n1;
  assign size_2 = Val_n2[WIDTH+2] ? -Val_n2 : Val_n2;
  assign size_3 = Val_n3[WIDTH+2] ? -Val_n3 : Val_n3;
  // n1 lies between n2 and n3, for one step adds to F and the other takes away. So the least of the three |n| is not
  // |n2| where |n1| < |n2|, and not |n3| where |n1| < |n3|. They are never equal: of neighbours one is even, one odd.
  assign step_x = size_1 < size_2;
  assign step_z = size_1 < size_3;

  arc_search #(.WIDTH(WIDTH), .FIRST_QUADRANT(FIRST_QUADRANT)) search (
      .clk(clk), .rst(rst), .start_x(Start_X0), .start_z(Start_Z0), .end_x(End_X1), .end_z(End_Z1), .clockwise(Cw),
      .syn(Syn), .step_x(step_x), .step_z(step_z), .x(Val_x), .z(Val_z), .f(Val_f), .by_x(by_x), .by_z(by_z),
      .x_shrinks(x_shrinks), .x_pulse(X_Pwm_Out), .z_pulse(Z_Pwm_Out), .x_up(X_Dir), .z_up(Z_Dir), .busy(Busy),
      .refused(Err));

  logic unused;
  assign unused = &{1'b0, x_shrinks};
endmodule
