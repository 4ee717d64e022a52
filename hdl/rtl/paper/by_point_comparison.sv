// Circular interpolation by point comparison ("FPGA-based implementation of circular interpolation", eqs. 1 to 5): one axis
// a clock. Inside the circle the coordinate that grows steps, outside the one that shrinks; on the circle the path goes
// outward, for which the paper's error of 0.877 speaks, though its text says inward.

module by_point_comparison #(
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
    output logic signed [WIDTH+2:0] Val_f       // F = x² + z² − R²
);
  logic signed [WIDTH+2:0] by_x, by_z;
  logic x_shrinks, grows, step_x, step_z;

  assign grows = Val_f <= 0;
  assign step_x = grows ^ x_shrinks;
  assign step_z = ~step_x;

  arc_search #(.WIDTH(WIDTH), .FIRST_QUADRANT(FIRST_QUADRANT)) search (
      .clk(clk), .rst(rst), .start_x(Start_X0), .start_z(Start_Z0), .end_x(End_X1), .end_z(End_Z1), .clockwise(Cw),
      .syn(Syn), .step_x(step_x), .step_z(step_z), .x(Val_x), .z(Val_z), .f(Val_f), .by_x(by_x), .by_z(by_z),
      .x_shrinks(x_shrinks), .x_pulse(X_Pwm_Out), .z_pulse(Z_Pwm_Out), .x_up(X_Dir), .z_up(Z_Dir), .busy(Busy),
      .refused(Err));

  logic unused;
  assign unused = &{1'b0, by_x, by_z};
endmodule
