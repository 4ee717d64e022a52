// The paper's four circular interpolators, of which `method` selects one where `start` is high; it makes the arc to its end.
//   0 point comparison, 1 DDA, 2 minimum error, 3 improved minimum error
module paper_interpolators #(
    parameter int WIDTH = 16  // of the coordinates, signed: 4 … 31
) (
    input logic clk,
    input logic rst,  // synchronous

    input  logic signed [WIDTH-1:0] start_x,  // steps, about the circle's centre
    input  logic signed [WIDTH-1:0] start_z,
    input  logic signed [WIDTH-1:0] end_x,
    input  logic signed [WIDTH-1:0] end_z,
    input  logic                    clockwise,
    input  logic        [      1:0] method,
    input  logic                    start,      // one clock; while busy it is ignored
    output logic                    busy,
    output logic                    refused,    // what was started is no arc
    output logic signed [WIDTH-1:0] x,          // where it is
    output logic signed [WIDTH-1:0] z,
    output logic                    x_pulse,
    output logic                    z_pulse,
    output logic                    x_up,
    output logic                    z_up
);
  logic [1:0] selected;
  logic [3:0] starts, are_busy, are_refused, x_pulses, z_pulses, x_ups, z_ups;
  logic [4*WIDTH-1:0] all_x, all_z;

  assign starts = start && !busy ? 4'b0001 << method : 4'b0000;
  always_ff @(posedge clk) begin
    if (rst) selected <= 2'd0;
    else if (start && !busy) selected <= method;
  end

  assign busy = are_busy[selected];
  assign refused = are_refused[selected];
  assign x = all_x[selected*WIDTH+:WIDTH];
  assign z = all_z[selected*WIDTH+:WIDTH];
  assign x_pulse = x_pulses[selected];
  assign z_pulse = z_pulses[selected];
  assign x_up = x_ups[selected];
  assign z_up = z_ups[selected];

  // verilator lint_off PINCONNECTEMPTY
  by_point_comparison #(
      .WIDTH(WIDTH)
  ) point (
      .clk(clk),
      .rst(rst),
      .Start_X0(start_x),
      .Start_Z0(start_z),
      .End_X1(end_x),
      .End_Z1(end_z),
      .Cw(clockwise),
      .Syn(starts[0]),
      .X_Pwm_Out(x_pulses[0]),
      .Z_Pwm_Out(z_pulses[0]),
      .X_Dir(x_ups[0]),
      .Z_Dir(z_ups[0]),
      .Busy(are_busy[0]),
      .Err(are_refused[0]),
      .Val_x(all_x[0*WIDTH+:WIDTH]),
      .Val_z(all_z[0*WIDTH+:WIDTH]),
      .Val_f()
  );
  dda #(
      .WIDTH(WIDTH)
  ) integrators (
      .clk(clk),
      .rst(rst),
      .Start_X0(start_x),
      .Start_Z0(start_z),
      .End_X1(end_x),
      .End_Z1(end_z),
      .Cw(clockwise),
      .Syn(starts[1]),
      .X_Pwm_Out(x_pulses[1]),
      .Z_Pwm_Out(z_pulses[1]),
      .X_Dir(x_ups[1]),
      .Z_Dir(z_ups[1]),
      .Busy(are_busy[1]),
      .Err(are_refused[1]),
      .Val_x(all_x[1*WIDTH+:WIDTH]),
      .Val_z(all_z[1*WIDTH+:WIDTH]),
      .Sum_X(), .Sum_Z()
  );
  minimum_error #(
      .WIDTH(WIDTH)
  ) least (
      .clk(clk),
      .rst(rst),
      .Start_X0(start_x),
      .Start_Z0(start_z),
      .End_X1(end_x),
      .End_Z1(end_z),
      .Cw(clockwise),
      .Syn(starts[2]),
      .X_Pwm_Out(x_pulses[2]),
      .Z_Pwm_Out(z_pulses[2]),
      .X_Dir(x_ups[2]),
      .Z_Dir(z_ups[2]),
      .Busy(are_busy[2]),
      .Err(are_refused[2]),
      .Val_x(all_x[2*WIDTH+:WIDTH]),
      .Val_z(all_z[2*WIDTH+:WIDTH]),
      .Val_f(), .Val_n1(), .Val_n2(), .Val_n3()
  );
  improved_minimum_error #(
      .WIDTH(WIDTH)
  ) improved (
      .clk(clk),
      .rst(rst),
      .Start_X0(start_x),
      .Start_Z0(start_z),
      .End_X1(end_x),
      .End_Z1(end_z),
      .Cw(clockwise),
      .Syn(starts[3]),
      .X_Pwm_Out(x_pulses[3]),
      .Z_Pwm_Out(z_pulses[3]),
      .X_Dir(x_ups[3]),
      .Z_Dir(z_ups[3]),
      .Busy(are_busy[3]),
      .Err(are_refused[3]),
      .Val_x(all_x[3*WIDTH+:WIDTH]),
      .Val_z(all_z[3*WIDTH+:WIDTH]),
      .Val_f(), .Val_d()
  );
  // verilator lint_on PINCONNECTEMPTY
endmodule
