// motion_core.sv on the vectors of test_core_vectors.cpp, in any simulator: +commands=FILE, a line of fields in hexadecimal
// a command, and +steps=FILE, strobes and senses of each tick at which a command runs. Prints `passed`, or what differs.
module core_vectors;
  localparam int AXES = 3, WIDTH = 24, FEED_WIDTH = 40, UNIT = 2 * (WIDTH + 2);

  logic clk = 1'b0, rst = 1'b1, push = 1'b0;
  logic [WIDTH-1:0] count;
  logic dwell, final_one, running, busy, full, low, irq, latched;
  logic [FEED_WIDTH:0] feed, feed_straight;
  logic [4*AXES-1:0] source;
  logic [AXES-1:0] backward, strobe, sense, step, direction, expected_strobe, expected_sense;
  logic [1:0] curve;
  logic [UNIT-1:0] decision, straight, diagonal;
  logic [4:0] level, error;
  logic [15:0] tag;
  logic [31:0] done;
  logic [WIDTH-1:0] left;
  logic [32*AXES-1:0] position, latched_position;

  motion_core #(
      .AXES(AXES),
      .WIDTH(WIDTH),
      .FEED_WIDTH(FEED_WIDTH)
  ) core (
      .clk(clk), .rst(rst), .command_push(push), .command_count(count), .command_dwell(dwell),
      .command_final(final_one), .command_tag(16'd0), .command_feed(feed), .command_feed_straight(feed_straight),
      .command_source(source), .command_backward(backward), .command_curve(curve), .command_decision(decision),
      .command_straight(straight), .command_diagonal(diagonal), .fifo_level(level), .fifo_full(full),
      .watermark(5'd0), .fifo_low(low), .hold(1'b0), .abort_now(1'b0), .prescale(16'd0), .watchdog_period(32'd0),
      .watchdog_kick(1'b0), .running(running), .busy(busy), .running_tag(tag), .commands_done(done),
      .steps_left(left), .error(error), .error_clear(5'd0), .interrupt_enable(4'd0), .irq(irq), .position(position),
      .position_set(3'd0), .position_set_value(32'd0), .latch(1'b0), .probe(1'b0), .probe_enable(1'b0),
      .latched_position(latched_position), .latched(latched), .latch_clear(1'b0), .step_length({AXES{16'd1}}),
      .step_space({AXES{16'd0}}), .direction_setup({AXES{16'd0}}), .direction_hold({AXES{16'd0}}),
      .step_strobe(strobe), .step_backward(sense), .step(step), .direction(direction)
  );

  integer commands, steps, got, ticks = 0, idle = 0;
  reg [8*256-1:0] commands_name, steps_name;

  task fail(input integer why);
    begin
      $display("failed at tick %0d: %0d", ticks, why);
      $finish;
    end
  endtask

  initial begin
    if (!$value$plusargs("commands=%s", commands_name) || !$value$plusargs("steps=%s", steps_name)) fail(0);
    commands = $fopen(commands_name, "r");
    steps = $fopen(steps_name, "r");
    if (commands == 0 || steps == 0) fail(1);
    repeat (2) #1 clk = ~clk;
    rst = 1'b0;
    while (idle < 8) begin
      push = 1'b0;
      if (!full) begin
        got = $fscanf(commands, "%h %h %h %h %h %h %h %h %h %h %h", count, dwell, final_one, feed, feed_straight,
                      source, backward, curve, decision, straight, diagonal);
        push = got == 11;
      end
      #1;
      if (running) begin
        ticks = ticks + 1;
        got = $fscanf(steps, "%h %h", expected_strobe, expected_sense);
        if (got != 2) fail(2);
        if (strobe !== expected_strobe || (sense & strobe) !== expected_sense) fail(3);
      end else if (strobe !== '0) fail(4);
      idle = busy | push ? 0 : idle + 1;
      clk = 1'b1;
      #1 clk = 1'b0;
    end
    got = $fscanf(steps, "%h %h", expected_strobe, expected_sense);
    if (got == 2) fail(5);
    if (error !== '0) fail(6);
    $display("passed %0d ticks", ticks);
    $finish;
  end
endmodule
