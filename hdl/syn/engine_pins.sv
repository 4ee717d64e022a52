// The engine of two axes between registers, for a place on a device with fewer pins than its command has bits: the
// command is shifted in, what comes out is registered. Only to measure the engine's clock.
module engine_pins #(
    parameter int WIDTH = 24,
    parameter int FEED_WIDTH = 32
) (
    input logic clk,
    input logic rst,
    input logic hold,
    input logic abort_now,
    input logic shift,
    input logic shifted_in,
    output logic [1:0] step,
    output logic [1:0] backward,
    output logic [1:0] moves,
    output logic running,
    output logic last
);
  localparam int COMMAND_WIDTH = 3 * (WIDTH + 2) + 2 + 2 + 8 + 2 * (FEED_WIDTH + 1) + WIDTH + 1 + 2;

  logic [COMMAND_WIDTH-1:0] command;
  logic [1:0] wanted, sense, goes;
  logic go, runs, ends, take;

  engine #(
      .AXES(2),
      .WIDTH(WIDTH),
      .FEED_WIDTH(FEED_WIDTH)
  ) core (
      .clk(clk),
      .rst(rst),
      .go(go),
      .abort_now(abort_now),
      .next_valid(command[0]),
      .next_dwell(command[1]),
      .next_left(command[2+:WIDTH+1]),
      .next_feed(command[WIDTH+3+:FEED_WIDTH+1]),
      .next_feed_straight(command[WIDTH+FEED_WIDTH+4+:FEED_WIDTH+1]),
      .next_source(command[WIDTH+2*FEED_WIDTH+5+:8]),
      .next_backward(command[WIDTH+2*FEED_WIDTH+13+:2]),
      .next_curve(command[WIDTH+2*FEED_WIDTH+15+:2]),
      .next_decision(command[WIDTH+2*FEED_WIDTH+17+:WIDTH+2]),
      .next_straight(command[2*WIDTH+2*FEED_WIDTH+19+:WIDTH+2]),
      .next_diagonal(command[3*WIDTH+2*FEED_WIDTH+21+:WIDTH+2]),
      .take(take),
      .running(runs),
      .finished(ends),
      .steps_left(),
      .wanted(wanted),
      .backward(sense),
      .moves(goes)
  );

  always_ff @(posedge clk) begin
    go <= ~hold;
    if (shift | take) command <= {command[COMMAND_WIDTH-2:0], shifted_in};
    step <= wanted & {2{go}};
    backward <= sense;
    moves <= goes;
    running <= runs;
    last <= ends;
  end
endmodule
