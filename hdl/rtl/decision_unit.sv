// One decision of Bresenham's kind: an adder, and the sign of what it holds. See motion_core.sv.
//
//                E          S (straight)    D (diagonal)
//   E < 0        E + S      S + 2c          D + 2c
//   E ≥ 0        E + D      S + 2c          D + 4c          c = −1, 0, 1; of the first order S and D stay
module decision_unit #(
    parameter int WIDTH = 26,
    parameter int SECOND_ORDER = 1
) (
    input  logic             clk,
    input  logic             load,
    input  logic             go,     // a step of the driving axis
    input  logic [      1:0] curve,  // c
    input  logic [WIDTH-1:0] next_decision,
    input  logic [WIDTH-1:0] next_straight,
    input  logic [WIDTH-1:0] next_diagonal,
    output logic             steps   // E ≥ 0: this axis goes along
);
  logic [WIDTH-1:0] decision, straight, diagonal, once, twice;

  assign steps = ~decision[WIDTH-1];
  assign once  = {{(WIDTH - 2) {curve[1]}}, curve[0], 1'b0};
  assign twice = {{(WIDTH - 3) {curve[1]}}, curve[0] & (steps | curve[1]), curve[0] & ~steps, 1'b0};

  always_ff @(posedge clk) begin
    if (load) begin
      decision <= next_decision;
      straight <= next_straight;
      diagonal <= next_diagonal;
    end else if (go) begin
      decision <= decision + (steps ? diagonal : straight);
      if (SECOND_ORDER != 0) begin
        straight <= straight + once;
        diagonal <= diagonal + twice;
      end
    end
  end
endmodule
