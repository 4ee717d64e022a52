// Registers and motion core: everything behind the bus. The tops leadscrew_fsmc, leadscrew_axi and leadscrew_wishbone put a
// bus in front of it.
module leadscrew_core #(
    parameter int AXES = 3,        // 2 … 7
    parameter int WIDTH = 24,      // 4 … 30: of counts, bits: circles of R < 2^(WIDTH−1)
    parameter int FEED_WIDTH = 40, // of the feed DDA's remainder: 33 … 62
    parameter int DEPTH_LOG2 = 4,  // the FIFO holds 2^DEPTH_LOG2 commands
    parameter int PAPER_WIDTH = 0  // 4 … 31: the paper's interpolators too, with coordinates of so many bits
) (
    input logic clk,
    input logic rst,  // synchronous

    input  logic        reg_write,  // as registers.sv has them
    input  logic        reg_read,
    input  logic [ 8:2] reg_address,
    input  logic [31:0] reg_write_data,
    input  logic [ 3:0] reg_write_strobe,
    output logic [31:0] reg_read_data,
    output logic        reg_error,

    input logic hold_pin,  // high: no tick of the feed passes; a button, or the other half of a machine
    input logic probe,     // a touch probe
    output logic irq,      // to the processor, by INTERRUPT_ENABLE
    output logic running,  // a command is being made

    // To the drives
    output logic [AXES-1:0] step,
    output logic [AXES-1:0] direction,  // 1: backward
    // For one clock where a step is decided, before any of the drives' times: for models and counters
    output logic [AXES-1:0] step_strobe,
    output logic [AXES-1:0] step_backward,
    // Of the paper's interpolator that is selected; low where there is none
    output logic X_Pwm_Out,
    output logic Z_Pwm_Out,
    output logic X_Dir,
    output logic Z_Dir
);
  logic command_push, command_dwell, command_final, fifo_full, fifo_low, hold, abort_now, watchdog_kick, busy;
  logic latch, probe_enable, latched, latch_clear, core_irq;
  logic [WIDTH-1:0] command_count, steps_left;
  logic [15:0] command_tag, prescale, running_tag;
  logic [FEED_WIDTH:0] command_feed, command_feed_straight;
  logic [4*AXES-1:0] command_source;
  logic [AXES-1:0] command_backward, position_set;
  logic [1:0] command_curve;
  logic [(AXES-1)*(WIDTH+2)-1:0] command_decision, command_straight, command_diagonal;
  logic [DEPTH_LOG2:0] fifo_level, watermark;
  logic [31:0] watchdog_period, commands_done, position_set_value;
  logic [4:0] error, error_clear;
  logic [3:0] interrupt_enable;
  logic [AXES*32-1:0] position, latched_position;
  logic [AXES*16-1:0] step_length, step_space, direction_setup, direction_hold;
  logic [31:0] paper_start_x, paper_start_z, paper_end_x, paper_end_z, paper_x, paper_z;
  logic [1:0] paper_method;
  logic paper_clockwise, paper_start, paper_busy, paper_refused;

  registers #(
      .AXES(AXES),
      .WIDTH(WIDTH),
      .FEED_WIDTH(FEED_WIDTH),
      .DEPTH_LOG2(DEPTH_LOG2),
      .PAPER_WIDTH(PAPER_WIDTH)
  ) file (
      .clk(clk),
      .rst(rst),
      .reg_write(reg_write),
      .reg_read(reg_read),
      .reg_address(reg_address),
      .reg_write_data(reg_write_data),
      .reg_write_strobe(reg_write_strobe),
      .reg_read_data(reg_read_data),
      .reg_error(reg_error),
      .hold_pin(hold_pin),
      .irq(irq),
      .core_irq(core_irq),
      .command_push(command_push),
      .command_count(command_count),
      .command_dwell(command_dwell),
      .command_final(command_final),
      .command_tag(command_tag),
      .command_feed(command_feed),
      .command_feed_straight(command_feed_straight),
      .command_source(command_source),
      .command_backward(command_backward),
      .command_curve(command_curve),
      .command_decision(command_decision),
      .command_straight(command_straight),
      .command_diagonal(command_diagonal),
      .fifo_level(fifo_level),
      .fifo_full(fifo_full),
      .watermark(watermark),
      .fifo_low(fifo_low),
      .hold(hold),
      .abort_now(abort_now),
      .prescale(prescale),
      .watchdog_period(watchdog_period),
      .watchdog_kick(watchdog_kick),
      .running(running),
      .busy(busy),
      .running_tag(running_tag),
      .commands_done(commands_done),
      .steps_left(steps_left),
      .error(error),
      .error_clear(error_clear),
      .interrupt_enable(interrupt_enable),
      .position(position),
      .position_set(position_set),
      .position_set_value(position_set_value),
      .latch(latch),
      .probe_enable(probe_enable),
      .latched_position(latched_position),
      .latched(latched),
      .latch_clear(latch_clear),
      .step_length(step_length),
      .step_space(step_space),
      .direction_setup(direction_setup),
      .direction_hold(direction_hold),
      .paper_start_x(paper_start_x),
      .paper_start_z(paper_start_z),
      .paper_end_x(paper_end_x),
      .paper_end_z(paper_end_z),
      .paper_method(paper_method),
      .paper_clockwise(paper_clockwise),
      .paper_start(paper_start),
      .paper_busy(paper_busy),
      .paper_refused(paper_refused),
      .paper_x(paper_x),
      .paper_z(paper_z)
  );

  motion_core #(
      .AXES(AXES),
      .WIDTH(WIDTH),
      .FEED_WIDTH(FEED_WIDTH),
      .DEPTH_LOG2(DEPTH_LOG2)
  ) motion (
      .clk(clk),
      .rst(rst),
      .probe(probe),
      .irq(core_irq),
      .command_push(command_push),
      .command_count(command_count),
      .command_dwell(command_dwell),
      .command_final(command_final),
      .command_tag(command_tag),
      .command_feed(command_feed),
      .command_feed_straight(command_feed_straight),
      .command_source(command_source),
      .command_backward(command_backward),
      .command_curve(command_curve),
      .command_decision(command_decision),
      .command_straight(command_straight),
      .command_diagonal(command_diagonal),
      .fifo_level(fifo_level),
      .fifo_full(fifo_full),
      .watermark(watermark),
      .fifo_low(fifo_low),
      .hold(hold),
      .abort_now(abort_now),
      .prescale(prescale),
      .watchdog_period(watchdog_period),
      .watchdog_kick(watchdog_kick),
      .running(running),
      .busy(busy),
      .running_tag(running_tag),
      .commands_done(commands_done),
      .steps_left(steps_left),
      .error(error),
      .error_clear(error_clear),
      .interrupt_enable(interrupt_enable),
      .position(position),
      .position_set(position_set),
      .position_set_value(position_set_value),
      .latch(latch),
      .probe_enable(probe_enable),
      .latched_position(latched_position),
      .latched(latched),
      .latch_clear(latch_clear),
      .step_length(step_length),
      .step_space(step_space),
      .direction_setup(direction_setup),
      .direction_hold(direction_hold),
      .step_strobe(step_strobe),
      .step_backward(step_backward),
      .step(step),
      .direction(direction)
  );

  generate
    if (PAPER_WIDTH > 0) begin : paper
      logic signed [PAPER_WIDTH-1:0] x, z;
      assign paper_x = 32'(x);
      assign paper_z = 32'(z);
      paper_interpolators #(
          .WIDTH(PAPER_WIDTH)
      ) interpolators (
          .clk(clk),
          .rst(rst),
          .start_x(paper_start_x[PAPER_WIDTH-1:0]),
          .start_z(paper_start_z[PAPER_WIDTH-1:0]),
          .end_x(paper_end_x[PAPER_WIDTH-1:0]),
          .end_z(paper_end_z[PAPER_WIDTH-1:0]),
          .clockwise(paper_clockwise),
          .method(paper_method),
          .start(paper_start),
          .busy(paper_busy),
          .refused(paper_refused),
          .x(x),
          .z(z),
          .x_pulse(X_Pwm_Out),
          .z_pulse(Z_Pwm_Out),
          .x_up(X_Dir),
          .z_up(Z_Dir)
      );
    end else begin : no_paper
      assign {paper_busy, paper_refused, paper_x, paper_z} = '0;
      assign {X_Pwm_Out, Z_Pwm_Out, X_Dir, Z_Dir} = '0;
    end
  endgenerate

  // Without them nothing takes these; with them only as many bits as they have.
  logic unused;
  assign unused = &{
    1'b0, paper_start_x, paper_start_z, paper_end_x, paper_end_z, paper_method, paper_clockwise, paper_start
  };
endmodule
