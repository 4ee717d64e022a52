// Koren's hardware interpolator ("Interpolator for a computer numerical control system", Fig. 3): a feed DDA whose overflows
// are the clock of two integrators with registers of a fixed length.
//
//            f                      y1 ──▶ r1 ──▶ Δz1                    line:  X ← Δz1, Y ← Δz2; y1 = a, y2 = b
//   clk ──▶ feed DDA, q0 ──▶ ┤                                           arc:   Y ← Δz1, X ← Δz2; y1 = R cos, y2 = R sin,
//                                   y2 ──▶ r2 ──▶ Δz2                           and Δy1 = ∓Δz2, Δy2 = ±Δz1
//
// Integrators overflow where r > q (eq. 3), begin empty and are clocked together. A line takes L/q of the commands for
// each BLU of its length, an arc turns by 1/q rad a command: V = L f w0/(q q0), ω = f w0/(q q0) (eqs. 11, 13), so
// f = 10 V0/l = 600 V/L and f = 10 V0/r = 600 V/R (eqs. 14 to 17) with q = 120 000, q0 = 10 000 and a clock of 2 MHz.
//
// A down counter for each axis stops it (his position routine): loaded with all ones it never does. Within one quadrant
// y1 and y2 do not change their signs; the next quadrant is another load.

module koren_hw #(
    parameter int Q = 120000,     // capacity of the integrators; at most 2^17
    parameter int Q0 = 10000,     // of the feed DDA; at most 2^14
    parameter bit STRICT = 1'b1   // overflow where r > q; 0: r ≥ q
) (
    input  logic        clk,        // 2 MHz
    input  logic        rst,        // synchronous
    input  logic        load,       // takes what follows, empties the remainders and starts
    input  logic        is_arc,
    input  logic        grows_1,    // of an arc: y1 increases and y2 decreases; else the other way round
    input  logic [13:0] f,          // feed word, at most Q0
    input  logic [16:0] begin_1,    // y1: a, or |R cos|, BLU; at most Q
    input  logic [16:0] begin_2,    // y2: b, or |R sin|
    input  logic [17:0] steps_x,    // that the axis has to make; all ones: without an end
    input  logic [17:0] steps_y,
    output logic        command,    // the feed DDA overflows at this clock
    output logic        x_pulse,    // high for one clock: X has stepped
    output logic        y_pulse,
    output logic        busy,       // from load to the last pulse
    output logic [16:0] y1,
    output logic [16:0] y2,
    output logic [17:0] r1,
    output logic [17:0] r2,
    output logic [17:0] left_x,     // of the down counters
    output logic [17:0] left_y
);
  logic running, arc, up_1, left_1, left_2, dz1, dz2, goes_x, goes_y;
  logic [13:0] word;
  logic [14:0] unused_feed;

  assign running = left_x != '0 || left_y != '0;
  assign left_1 = arc ? left_y != '0 : left_x != '0;
  assign left_2 = arc ? left_x != '0 : left_y != '0;
  assign goes_x = arc ? dz2 : dz1;
  assign goes_y = arc ? dz1 : dz2;

  digital_integrator #(.WIDTH(14)) feed (
      .clk(clk), .load(load || rst), .enable(running), .integrand(word), .capacity(15'(Q0)), .preload(15'd0),
      .overflow(command), .remainder(unused_feed));
  digital_integrator #(.WIDTH(17), .STRICT(STRICT)) first (
      .clk(clk), .load(load || rst), .enable(command && left_1), .integrand(y1), .capacity(18'(Q)), .preload(18'd0),
      .overflow(dz1), .remainder(r1));
  digital_integrator #(.WIDTH(17), .STRICT(STRICT)) second (
      .clk(clk), .load(load || rst), .enable(command && left_2), .integrand(y2), .capacity(18'(Q)), .preload(18'd0),
      .overflow(dz2), .remainder(r2));

  always_ff @(posedge clk) begin
    x_pulse <= goes_x && !load && !rst;
    y_pulse <= goes_y && !load && !rst;
    busy <= !rst && (load || running);
    if (rst) begin
      left_x <= '0;
      left_y <= '0;
    end else if (load) begin
      left_x <= steps_x;
      left_y <= steps_y;
    end else begin
      if (goes_x && !(&left_x)) left_x <= left_x - 18'd1;
      if (goes_y && !(&left_y)) left_y <= left_y - 18'd1;
    end
    if (load) begin
      arc <= is_arc;
      up_1 <= grows_1;
      word <= f;
      y1 <= begin_1;
      y2 <= begin_2;
    end else if (arc) begin
      if (dz2) y1 <= up_1 ? y1 + 17'd1 : y1 - 17'd1;
      if (dz1) y2 <= up_1 ? y2 - 17'd1 : y2 + 17'd1;
    end
  end
endmodule
