// motion_core.sv of two axes and width 4: any lines, or any octants that begin on an axis (OCTANTS), one after the other,
// with any feeds of at least half a step a tick, times of drives, holds and aborts.
module core_properties #(
    parameter int WIDTH = 4,
    parameter bit OCTANTS = 1'b0
) (
    input logic clk,
    input logic any_hold,
    input logic any_abort,
    input logic any_push,
    input logic x_drives,
    input logic [1:0] any_backward,
    input logic [WIDTH-1:0] any_count,  // of a line; of an octant: steps of g
    input logic [WIDTH-1:0] any_other,  // of a line: steps of the other axis; of an octant: s at its start
    input logic [2:0] any_feed,
    input logic [3:0] any_times,
    input logic with_aborts,
    input logic with_waits,
    output logic fails_position,  // the pulses seen sum to the position
    output logic fails_idle,      // no step without a command, on hold or at an abort
    output logic fails_end,       // a line ends where it is to, exactly
    output logic fails_octant,    // every step is one of the two with the lesser |F|
    output logic fails_busy,      // busy for no longer than the feeds ask for
    output logic fails_count,     // as many commands end as were taken
    output logic fails_error      // errors tell what happened, and only that
);
  localparam int FEED_WIDTH = 2, LONG = 8;

  logic begun, rst, hold, abort_now, may_abort, may_wait, push;
  logic [1:0] times;
  assign rst = ~begun;
  assign hold = any_hold;
  assign abort_now = any_abort & may_abort;
  initial begun = 1'b0;

  // One command at a time, so that what it is to make is known: a line of other ≤ count, or g from 0 on while g < s.
  logic busy, full, low, running, irq, latched, waiting;
  logic [WIDTH-1:0] count, other, s, g;
  logic octant, swapped;
  logic [1:0] sense, step_strobe, step_backward, step, direction;
  logic [WIDTH+1:0] decision, straight, diagonal;
  logic fits, is_octant;
  assign is_octant = OCTANTS;
  assign fits = any_count != '0 & (is_octant ? any_other[WIDTH-1:WIDTH-1] == 1'b0 & any_count < any_other
                                             : any_other <= any_count);
  assign push = any_push & ~busy & ~waiting & fits & ~abort_now;
  always_comb begin
    if (is_octant) begin  // s = any_other, g = 0, F = 0: a = 1 − 2 s, b = 1
      decision = (WIDTH + 2)'(1) - (WIDTH + 2)'(any_other);
      straight = (WIDTH + 2)'(3);
      diagonal = (WIDTH + 2)'(5) - {1'b0, any_other, 1'b0};
    end else begin
      decision = {1'b0, any_other, 1'b0} - (WIDTH + 2)'(any_count) - 1'b1;
      straight = {1'b0, any_other, 1'b0};
      diagonal = {1'b0, any_other, 1'b0} - {1'b0, any_count, 1'b0};
    end
  end

  logic [4:0] error;
  logic [2*6-1:0] position, latched_position;
  logic [15:0] running_tag;
  logic [31:0] commands_done;
  logic [WIDTH-1:0] steps_left;
  logic [1:0] level;
  motion_core #(
      .AXES(2),
      .WIDTH(WIDTH),
      .FEED_WIDTH(FEED_WIDTH),
      .DEPTH_LOG2(1),
      .POSITION_WIDTH(6),
      .TIME_WIDTH(2)
  ) core (
      .clk(clk),
      .rst(rst),
      .command_push(push),
      .command_count(any_count),
      .command_dwell(1'b0),
      .command_final(1'b1),
      .command_tag(16'd0),
      .command_feed({any_feed[2], any_feed[2] ? 2'b00 : {1'b1, any_feed[0]}}),
      .command_feed_straight({any_feed[2], any_feed[2] ? 2'b00 : {1'b1, any_feed[1]}}),
      .command_source(x_drives ? 8'h21 : 8'h12),
      .command_backward(any_backward),
      .command_curve({1'b0, is_octant}),
      .command_decision(decision),
      .command_straight(straight),
      .command_diagonal(diagonal),
      .fifo_level(level),
      .fifo_full(full),
      .watermark(2'd0),
      .fifo_low(low),
      .hold(hold),
      .abort_now(abort_now),
      .prescale(16'd0),
      .watchdog_period(32'd0),
      .watchdog_kick(1'b0),
      .running(running),
      .busy(busy),
      .running_tag(running_tag),
      .commands_done(commands_done),
      .steps_left(steps_left),
      .error(error),
      .error_clear(5'd0),
      .interrupt_enable(4'd0),
      .irq(irq),
      .position(position),
      .position_set(2'd0),
      .position_set_value(6'd0),
      .latch(1'b0),
      .probe(1'b0),
      .probe_enable(1'b0),
      .latched_position(latched_position),
      .latched(latched),
      .latch_clear(1'b0),
      .step_length(4'b0101),
      .step_space({1'b0, may_wait, 1'b0, may_wait}),
      .direction_setup({may_wait & times[0], 1'b0, 2'b00}),
      .direction_hold({2'b00, may_wait & times[1], 1'b0}),
      .step_strobe(step_strobe),
      .step_backward(step_backward),
      .step(step),
      .direction(direction)
  );

  // What is to be and what is
  logic [5:0] seen_x, seen_y;
  logic [WIDTH-1:0] made, made_other;
  logic [1:0] was_strobe;
  logic was_running, aborted, ends, driving, following;
  logic [LONG-1:0] since_push, allowed;
  logic [3:0] pushed;
  assign driving = swapped ? step_strobe[1] : step_strobe[0];
  assign following = swapped ? step_strobe[0] : step_strobe[1];
  assign ends = was_running & ~running & ~aborted;

  // F of the point where a step leads, and of the other point that it could have led to
  logic signed [2*WIDTH+2:0] f_made, f_other, s_made, s_other, g_made, s_start;
  assign s_start = $signed({{(WIDTH + 3) {1'b0}}, other});
  assign g_made = $signed({{(WIDTH + 3) {1'b0}}, g}) + 1;
  assign s_made = $signed({{(WIDTH + 3) {1'b0}}, s}) - (following ? 1 : 0);
  assign s_other = $signed({{(WIDTH + 3) {1'b0}}, s}) - (following ? 0 : 1);
  assign f_made = g_made * g_made + s_made * s_made - s_start * s_start;
  assign f_other = g_made * g_made + s_other * s_other - s_start * s_start;

  always_ff @(posedge clk) begin
    begun <= 1'b1;
    if (rst) begin
      {seen_x, seen_y} <= '0;
      {was_strobe, was_running, aborted, waiting} <= '0;
      {made, made_other, since_push, pushed, count, other} <= '0;
      octant <= 1'b0;
      may_abort <= with_aborts;
      may_wait <= with_waits;
      times <= any_times[1:0];
    end else begin
      // Pulses of one clock: a pulse at each clock at which the signal is high
      if (step[0]) seen_x <= direction[0] ? seen_x - 1'b1 : seen_x + 1'b1;
      if (step[1]) seen_y <= direction[1] ? seen_y - 1'b1 : seen_y + 1'b1;
      was_strobe <= step_strobe;
      was_running <= running;
      waiting <= push;
      if (~hold) since_push <= since_push + 1'b1;
      if (push) begin
        {count, other, sense, octant, swapped} <= {any_count, any_other, any_backward, is_octant, ~x_drives};
        {made, made_other, since_push, aborted} <= '0;
        s <= any_other;
        g <= '0;
        pushed <= pushed + 1'b1;
        allowed <= {2'b00, any_count, 2'b00} + 8'd8;
      end else begin
        if (driving) made <= made + 1'b1;
        if (following) made_other <= made_other + 1'b1;
        if (driving) g <= g + 1'b1;
        if (driving & following) s <= s - 1'b1;
        if (abort_now) aborted <= 1'b1;
      end
    end
  end

  assign fails_position = begun & position != {seen_y + (step[1] ? (direction[1] ? 6'h3f : 6'h01) : 6'h00),
                                                     seen_x + (step[0] ? (direction[0] ? 6'h3f : 6'h01) : 6'h00)};
  assign fails_idle = begun & (step_strobe != '0 & (~running | hold | abort_now) | step != was_strobe);
  assign fails_end = begun & (ends & ~octant & (made != count | made_other != other)
                              | ends & octant & made != count
                              | step_strobe != '0 & (step_backward & step_strobe) != (sense & step_strobe));
  assign fails_octant = begun & octant & driving & (f_made < 0 ? -f_made : f_made) > (f_other < 0 ? -f_other : f_other);
  assign fails_busy = begun & busy & ~may_wait & since_push > allowed;
  assign fails_count = begun & ~may_abort & ~busy & ~waiting & ~running & commands_done[3:0] != pushed;
  assign fails_error = begun & (error[4] | error[2] | error[1] | error[0] | (error[3] & ~may_wait));
endmodule
