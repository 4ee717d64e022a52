// The linear interpolator of the lectures: a feed DDA of M bits, which holds S, gives the clock of two axis DDAs of N bits,
// which hold the distances; each overflows by the carry of its adder. Behind it, for each axis, what ends its motion and
// what its servo loop follows:
//
//   F ──▶ feed DDA ──┬──▶ axis DDA ──▶ AND gate ──▶ UDC up or down ◀── encoder      UDC: the following error
//          S/2^M     │      dx/2^N       ▲  └──▶ PDC down                           PDC: pulses that are still to come;
//                    └──▶ …              └── PDC > 0                                     at 0 the gate is shut
//
// The rate of an axis is F · S/2^M · dx/2^N: with F = 2^(M+N)/600 pps, S = 600 V/L.

module lecture_dda #(
    parameter int M = 12,
    parameter int N = 16
) (
    input  logic                clk,          // F
    input  logic                rst,          // synchronous; empties everything
    input  logic                load,         // takes the next eight; UDCs stay as they are
    input  logic [M-1:0]        S,            // feed word
    input  logic [N-1:0]        dx,           // BLU
    input  logic [N-1:0]        dy,
    input  logic [N:0]          pulses_x,     // that may pass the gate: dx
    input  logic [N:0]          pulses_y,
    input  logic                x_down,       // the sense
    input  logic                y_down,
    input  logic                encoder_x,    // high for one clock: the slide has moved by a BLU
    input  logic                encoder_x_down,
    input  logic                encoder_y,
    input  logic                encoder_y_down,
    output logic                command,      // the feed DDA overflows at this clock
    output logic                x_pulse,      // high for one clock: a pulse has passed the gate
    output logic                y_pulse,
    output logic                busy,         // a PDC is not at 0
    output logic [N:0]          pdc_x,
    output logic [N:0]          pdc_y,
    output logic signed [N-1:0] udc_x,        // BLU; stays at its greatest and least
    output logic signed [N-1:0] udc_y
);
  logic [M-1:0] word;
  logic [N-1:0] held_x, held_y;
  logic [M:0] unused_feed;
  logic [N:0] unused_x, unused_y;
  logic overflow_x, overflow_y, down_x, down_y, passes_x, passes_y;

  assign busy = pdc_x != '0 || pdc_y != '0;
  assign passes_x = overflow_x && pdc_x != '0;
  assign passes_y = overflow_y && pdc_y != '0;

  digital_integrator #(.WIDTH(M)) feed (
      .clk(clk), .load(load || rst), .enable(busy), .integrand(word), .capacity({1'b1, {M{1'b0}}}), .preload((M + 1)'(0)),
      .overflow(command), .remainder(unused_feed));
  digital_integrator #(.WIDTH(N)) x_axis (
      .clk(clk), .load(load || rst), .enable(command), .integrand(held_x), .capacity({1'b1, {N{1'b0}}}), .preload((N + 1)'(0)),
      .overflow(overflow_x), .remainder(unused_x));
  digital_integrator #(.WIDTH(N)) y_axis (
      .clk(clk), .load(load || rst), .enable(command), .integrand(held_y), .capacity({1'b1, {N{1'b0}}}), .preload((N + 1)'(0)),
      .overflow(overflow_y), .remainder(unused_y));
  up_down_counter #(.WIDTH(N)) x_counter (
      .clk(clk), .rst(rst), .command(passes_x && !load), .command_down(down_x), .encoder(encoder_x),
      .encoder_down(encoder_x_down), .count(udc_x));
  up_down_counter #(.WIDTH(N)) y_counter (
      .clk(clk), .rst(rst), .command(passes_y && !load), .command_down(down_y), .encoder(encoder_y),
      .encoder_down(encoder_y_down), .count(udc_y));

  always_ff @(posedge clk) begin
    x_pulse <= passes_x && !load && !rst;
    y_pulse <= passes_y && !load && !rst;
    if (rst) begin
      pdc_x <= '0;
      pdc_y <= '0;
    end else if (load) begin
      pdc_x <= pulses_x;
      pdc_y <= pulses_y;
    end else begin
      if (passes_x) pdc_x <= pdc_x - (N + 1)'(1);
      if (passes_y) pdc_y <= pdc_y - (N + 1)'(1);
    end
    if (load) begin
      word <= S;
      held_x <= dx;
      held_y <= dy;
      down_x <= x_down;
      down_y <= y_down;
    end
  end
endmodule
