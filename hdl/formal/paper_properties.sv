// One of the four circular interpolators of rtl/paper, CORE, at width 4: any arc that is asked for in the clock behind the reset, of
// radii up to 5, in both directions, full circles too; or what is no arc.
module paper_properties #(
    parameter int WIDTH = 4,
    parameter int MOST_CLOCKS = 40  // that the longest arc takes
) (
    input logic clk,
    input logic signed [WIDTH-1:0] any_start_x,
    input logic signed [WIDTH-1:0] any_start_z,
    input logic signed [WIDTH-1:0] any_end_x,
    input logic signed [WIDTH-1:0] any_end_z,
    input logic any_clockwise,
    output logic fails_position,  // where it is changes by the pulses, and by nothing else
    output logic fails_idle,      // no pulse but while it is busy, none of what is no arc
    output logic fails_end,       // it rests where the arc ends, exactly
    output logic fails_busy       // Busy falls within the clocks that the longest arc takes
);
  logic [1:0] begun;
  logic rst, syn;
  initial begun = 2'd0;
  always_ff @(posedge clk) if (begun != 2'd2) begun <= begun + 2'd1;
  logic live;  // from the clock behind Syn on
  assign live = begun == 2'd2;
  assign rst = begun == 2'd0;
  assign syn = begun == 2'd1;

  logic x_pulse, z_pulse, x_up, z_up, busy, refused;
  logic signed [WIDTH-1:0] x, z;
  `CORE #(
      .WIDTH(WIDTH)
  ) core (
      .clk(clk),
      .rst(rst),
      .Start_X0(any_start_x),
      .Start_Z0(any_start_z),
      .End_X1(any_end_x),
      .End_Z1(any_end_z),
      .Cw(any_clockwise),
      .Syn(syn),
      .X_Pwm_Out(x_pulse),
      .Z_Pwm_Out(z_pulse),
      .X_Dir(x_up),
      .Z_Dir(z_up),
      .Busy(busy),
      .Err(refused),
      .Val_x(x),
      .Val_z(z)
  );

  logic was_busy;
  logic signed [WIDTH-1:0] last_x, last_z, end_x, end_z;
  logic [8:0] clocks;
  initial begin
    was_busy = 1'b0;
    clocks = 9'd0;
  end
  always_ff @(posedge clk) begin
    was_busy <= live && busy;
    if (syn) begin
      last_x <= any_start_x;
      last_z <= any_start_z;
      end_x <= any_end_x;
      end_z <= any_end_z;
    end else begin
      last_x <= x;
      last_z <= z;
    end
    clocks <= live && busy ? clocks + 9'd1 : 9'd0;
  end

  function automatic logic signed [WIDTH-1:0] moved(input logic signed [WIDTH-1:0] from, input logic pulse, input logic up);
    moved = !pulse ? from : up ? from + (WIDTH)'(1) : from - (WIDTH)'(1);
  endfunction
  assign fails_position = live && busy && (x != moved(last_x, x_pulse, x_up) || z != moved(last_z, z_pulse, z_up));
  assign fails_idle = live && (x_pulse || z_pulse) && (!busy || refused);
  assign fails_end = was_busy && !busy && (x != end_x || z != end_z);
  assign fails_busy = clocks > (9)'(MOST_CLOCKS);
endmodule
