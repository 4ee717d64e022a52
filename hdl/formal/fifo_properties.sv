// command_fifo.sv with any pushes and takes: of any one of its words, that it comes out, in its turn and as it was.
module fifo_properties #(
    parameter int WIDTH = 4,
    parameter int DEPTH_LOG2 = 2
) (
    input logic clk,
    input logic push,
    input logic take,
    input logic [WIDTH-1:0] in,
    input logic marks,           // this word is followed
    output logic fails_word,     // it comes out as it went in
    output logic fails_lost,     // no word comes out that was not pushed, none waits unseen for two clocks
    output logic fails_level,    // the level is the words inside
    output logic fails_overflow  // the full queue holds its depth, and takes no more
);
  logic begun, valid, full, pushes, takes, rst;
  logic [WIDTH-1:0] out, word;
  logic [DEPTH_LOG2:0] level, inside, before;
  logic followed, waited;
  assign rst = ~begun;
  assign pushes = push & ~full;
  assign takes = take & valid;
  initial begun = 1'b0;

  command_fifo #(
      .WIDTH(WIDTH),
      .DEPTH_LOG2(DEPTH_LOG2)
  ) fifo (
      .clk(clk),
      .rst(rst),
      .push(push),
      .in(in),
      .take(take),
      .out(out),
      .valid(valid),
      .full(full),
      .level(level)
  );

  always_ff @(posedge clk) begin
    begun <= 1'b1;
    if (rst) begin
      inside <= '0;
      followed <= 1'b0;
      waited <= 1'b0;
    end else begin
      inside <= inside + (DEPTH_LOG2 + 1)'(pushes) - (DEPTH_LOG2 + 1)'(takes);
      waited <= inside != '0 & ~takes;
      if (pushes & marks & ~followed) begin
        followed <= 1'b1;
        word <= in;
        before <= inside - (DEPTH_LOG2 + 1)'(takes);
      end else if (followed & takes) begin
        followed <= before != '0;
        before <= before - 1'b1;
      end
    end
  end

  assign fails_word = begun & followed & valid & before == '0 & out != word;
  assign fails_lost = begun & (valid & inside == '0 | waited & ~valid);
  assign fails_level = begun & level != inside;
  assign fails_overflow = begun & full != (inside == (DEPTH_LOG2 + 1)'(1 << DEPTH_LOG2));
endmodule
