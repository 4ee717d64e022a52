// A digital integrator (DDA): at every clock that is enabled the integrand is added to the remainder; where that
// overflows the capacity, the capacity is taken off and a pulse is due: integrand/capacity pulses a clock.
//
// Koren's integrators overflow where the remainder is above the capacity (STRICT = 1: 000, eq. 3), those that overflow
// by the carry of an adder where it is equal as well (STRICT = 0).

module digital_integrator #(
    parameter int WIDTH = 16,   // of the integrand, bits
    parameter bit STRICT = 1'b0
) (
    input  logic             clk,
    input  logic             load,       // takes `preload` as the remainder
    input  logic             enable,     // one addition at this clock
    input  logic [WIDTH-1:0] integrand,  // at most the capacity
    input  logic [WIDTH:0]   capacity,   // 1 … 2^WIDTH
    input  logic [WIDTH:0]   preload,    // below the capacity
    output logic             overflow,   // this addition overflows: with `enable`, before the clock's edge
    output logic [WIDTH:0]   remainder   // 0 … capacity − 1; STRICT: 0 … capacity
);
  logic [WIDTH+1:0] sum, excess;

  assign sum = {1'b0, remainder} + {2'b00, integrand};
  assign excess = sum - {1'b0, capacity} - (WIDTH + 2)'(STRICT);
  assign overflow = enable & ~excess[WIDTH+1];

  always_ff @(posedge clk)
    if (load) remainder <= preload;
    else if (enable) remainder <= overflow ? excess[WIDTH:0] + (WIDTH + 1)'(STRICT) : sum[WIDTH:0];
endmodule
