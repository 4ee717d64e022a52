// The registers of hdl/registers/registers.toml (docs/hardware-registers.md), between a bus and motion_core.
//
//   bus shim ──reg_…──▶ registers ──command, control──▶ motion_core
//                            ◀──positions, state, errors──
//
// The bus is synchronous: reg_write or reg_read for one clock each, never both; data and error are there in the next
// clock. A write that is not of all four bytes, or of a register that is only read, changes nothing and gives
// reg_error; so does any access to an address without a register. Both are sticky bits of ERROR as well, for buses
// that cannot tell an error. A read changes nothing.
module registers #(
    parameter int AXES = 3,  // as motion_core's
    parameter int WIDTH = 24,
    parameter int FEED_WIDTH = 40,
    parameter int DEPTH_LOG2 = 4,
    parameter int POSITION_WIDTH = 32,
    parameter int TIME_WIDTH = 16,
    parameter int PAPER_WIDTH = 0  // of the coordinates of the paper's interpolators; 0: there are none
) (
    input logic clk,
    input logic rst,  // synchronous

    input  logic        reg_write,
    input  logic        reg_read,
    input  logic [ 8:2] reg_address,
    input  logic [31:0] reg_write_data,
    input  logic [ 3:0] reg_write_strobe,
    output logic [31:0] reg_read_data,
    output logic        reg_error,

    input  logic hold_pin,  // motion is held while it is high, as by CONTROL.HOLD
    output logic irq,

    // As motion_core has them
    output logic                          command_push,
    output logic [             WIDTH-1:0] command_count,
    output logic                          command_dwell,
    output logic                          command_final,
    output logic [                  15:0] command_tag,
    output logic [          FEED_WIDTH:0] command_feed,
    output logic [          FEED_WIDTH:0] command_feed_straight,
    output logic [            4*AXES-1:0] command_source,
    output logic [              AXES-1:0] command_backward,
    output logic [                   1:0] command_curve,
    output logic [(AXES-1)*(WIDTH+2)-1:0] command_decision,
    output logic [(AXES-1)*(WIDTH+2)-1:0] command_straight,
    output logic [(AXES-1)*(WIDTH+2)-1:0] command_diagonal,

    input  logic [DEPTH_LOG2:0] fifo_level,
    input  logic                fifo_full,
    output logic [DEPTH_LOG2:0] watermark,
    input  logic                fifo_low,

    output logic             hold,
    output logic             abort_now,
    output logic [     15:0] prescale,
    output logic [     31:0] watchdog_period,
    output logic             watchdog_kick,
    input  logic             running,
    input  logic             busy,
    input  logic [     15:0] running_tag,
    input  logic [     31:0] commands_done,
    input  logic [WIDTH-1:0] steps_left,

    input  logic [4:0] error,
    output logic [4:0] error_clear,
    output logic [3:0] interrupt_enable,
    input  logic       core_irq,

    input  logic [AXES*POSITION_WIDTH-1:0] position,
    output logic [               AXES-1:0] position_set,
    output logic [     POSITION_WIDTH-1:0] position_set_value,
    output logic                           latch,
    output logic                           probe_enable,
    input  logic [AXES*POSITION_WIDTH-1:0] latched_position,
    input  logic                           latched,
    output logic                           latch_clear,

    output logic [AXES*TIME_WIDTH-1:0] step_length,
    output logic [AXES*TIME_WIDTH-1:0] step_space,
    output logic [AXES*TIME_WIDTH-1:0] direction_setup,
    output logic [AXES*TIME_WIDTH-1:0] direction_hold,

    // Of the paper's interpolators; signed, of which they take the lowest PAPER_WIDTH bits
    output logic [31:0] paper_start_x,
    output logic [31:0] paper_start_z,
    output logic [31:0] paper_end_x,
    output logic [31:0] paper_end_z,
    output logic [ 1:0] paper_method,
    output logic        paper_clockwise,
    output logic        paper_start,      // one clock
    input  logic        paper_busy,
    input  logic        paper_refused,
    input  logic [31:0] paper_x,
    input  logic [31:0] paper_z
);
  localparam int UNITS = AXES - 1, UNIT_WIDTH = WIDTH + 2;
  localparam logic HAS_PAPER = PAPER_WIDTH > 0;

  logic [8:0] place;
  assign place = {reg_address, 2'b00};

  logic [2:0] axis;
  logic error_address, error_partial;
  logic [6:0] all_errors;
  assign all_errors = {error_partial, error_address, error};

  assign irq = core_irq || (interrupt_enable[2] && (error_address || error_partial));

  logic hold_register;
  assign hold = hold_register || hold_pin;

  // What is at an address: for reads the value too.
  logic exists, can_write;
  logic [31:0] value;

  // Which of the registers of an array is at the address.
  function automatic logic is_of(input logic [8:0] at, input logic [8:0] first, input int stride, input int index);
    is_of = at == first + 9'(stride * index);
  endfunction

  // The signed or unsigned value of so many bits, the rest 0.
  function automatic logic [31:0] position_of(input logic [AXES*POSITION_WIDTH-1:0] all, input int index);
    logic signed [POSITION_WIDTH-1:0] one;
    one = all[index*POSITION_WIDTH+:POSITION_WIDTH];
    position_of = 32'(one);
  endfunction

  always_comb begin
    exists = 1'b1;
    can_write = 1'b0;
    value = 32'd0;
    case (place)
      registers_package::IDENTIFICATION: value = registers_package::IDENTIFICATION_VALUE;
      registers_package::VERSION: value = registers_package::VERSION_VALUE;
      registers_package::PARAMETERS:
      value = {2'b00, 6'(PAPER_WIDTH), 2'b00, 6'(FEED_WIDTH), 2'b00, 6'(WIDTH), 4'(DEPTH_LOG2), 4'(AXES)};
      registers_package::CONTROL: begin
        can_write = 1'b1;
        value = {30'd0, probe_enable, hold_register};
      end
      registers_package::STATUS:
      value = {running_tag, 9'd0, hold, irq, latched, fifo_low, fifo_full, busy, running};
      registers_package::ERROR: begin
        can_write = 1'b1;
        value = {25'd0, all_errors};
      end
      registers_package::INTERRUPT_ENABLE: begin
        can_write = 1'b1;
        value = {28'd0, interrupt_enable};
      end
      registers_package::INTERRUPT_STATUS: value = {28'd0, latched, |all_errors, !busy, fifo_low};
      registers_package::FIFO_LEVEL: value = 32'(fifo_level);
      registers_package::WATERMARK: begin
        can_write = 1'b1;
        value = 32'(watermark);
      end
      registers_package::PRESCALE: begin
        can_write = 1'b1;
        value = {16'd0, prescale};
      end
      registers_package::WATCHDOG_PERIOD: begin
        can_write = 1'b1;
        value = watchdog_period;
      end
      registers_package::COMMANDS_DONE: value = commands_done;
      registers_package::STEPS_LEFT: value = 32'(steps_left);
      registers_package::AXIS: begin
        can_write = 1'b1;
        value = {29'd0, axis};
      end
      registers_package::STEP_TIMES: begin
        can_write = 1'b1;
        for (int i = 0; i < AXES; i = i + 1) begin
          if (axis == 3'(i))
            value = {16'(step_space[i*TIME_WIDTH+:TIME_WIDTH]), 16'(step_length[i*TIME_WIDTH+:TIME_WIDTH])};
        end
      end
      registers_package::DIRECTION_TIMES: begin
        can_write = 1'b1;
        for (int i = 0; i < AXES; i = i + 1) begin
          if (axis == 3'(i))
            value = {16'(direction_hold[i*TIME_WIDTH+:TIME_WIDTH]), 16'(direction_setup[i*TIME_WIDTH+:TIME_WIDTH])};
        end
      end
      registers_package::POSITION_VALUE: begin
        can_write = 1'b1;
        value = 32'(position_set_value);
      end
      registers_package::TRIGGER, registers_package::POSITION_SET, registers_package::COMMAND_COUNT,
      registers_package::COMMAND_FEED_LOW, registers_package::COMMAND_FEED_HIGH,
      registers_package::COMMAND_STRAIGHT_FEED_LOW, registers_package::COMMAND_STRAIGHT_FEED_HIGH,
      registers_package::COMMAND_SOURCE, registers_package::COMMAND_PUSH:
      can_write = 1'b1;
      default: begin
        exists = 1'b0;
        for (int i = 0; i < registers_package::POSITION_COUNT; i = i + 1) begin
          if (is_of(place, registers_package::POSITION, registers_package::POSITION_STRIDE, i)) begin
            exists = 1'b1;
            if (i < AXES) value = position_of(position, i);
          end
          if (is_of(place, registers_package::LATCHED, registers_package::LATCHED_STRIDE, i)) begin
            exists = 1'b1;
            if (i < AXES) value = position_of(latched_position, i);
          end
        end
        if (place >= registers_package::UNIT_DECISION &&
            place < registers_package::UNIT_DECISION +
                9'(registers_package::UNIT_DECISION_STRIDE * registers_package::UNIT_DECISION_COUNT)) begin
          exists = 1'b1;
          can_write = 1'b1;
        end
        if (HAS_PAPER) begin
          case (place)
            registers_package::PAPER_START_X: {exists, can_write, value} = {2'b11, paper_start_x};
            registers_package::PAPER_START_Z: {exists, can_write, value} = {2'b11, paper_start_z};
            registers_package::PAPER_END_X: {exists, can_write, value} = {2'b11, paper_end_x};
            registers_package::PAPER_END_Z: {exists, can_write, value} = {2'b11, paper_end_z};
            registers_package::PAPER_METHOD:
            {exists, can_write, value} = {2'b11, 27'd0, paper_clockwise, 2'b00, paper_method};
            registers_package::PAPER_START: {exists, can_write} = 2'b11;
            registers_package::PAPER_STATUS: {exists, value} = {1'b1, 30'd0, paper_refused, paper_busy};
            registers_package::PAPER_X: {exists, value} = {1'b1, paper_x};
            registers_package::PAPER_Z: {exists, value} = {1'b1, paper_z};
            default: ;
          endcase
        end
      end
    endcase
  end

  logic refused, accepted;
  assign refused = reg_write && exists && (!can_write || reg_write_strobe != 4'b1111);
  assign accepted = reg_write && exists && !refused;

  // Reads, and errors of the bus.
  always_ff @(posedge clk) begin
    if (reg_read) reg_read_data <= value;
    reg_error <= refused || ((reg_write || reg_read) && !exists);
    if (accepted && place == registers_package::ERROR) begin
      if (reg_write_data[registers_package::ERROR_ADDRESS_BIT]) error_address <= 1'b0;
      if (reg_write_data[registers_package::ERROR_PARTIAL_BIT]) error_partial <= 1'b0;
    end
    if ((reg_write || reg_read) && !exists) error_address <= 1'b1;
    if (refused) error_partial <= 1'b1;
    if (rst) begin
      reg_read_data <= 32'd0;
      reg_error <= 1'b0;
      error_address <= 1'b0;
      error_partial <= 1'b0;
    end
  end

  // What a write makes happen for one clock.
  always_ff @(posedge clk) begin
    abort_now <= 1'b0;
    latch <= 1'b0;
    latch_clear <= 1'b0;
    watchdog_kick <= 1'b0;
    error_clear <= 5'd0;
    position_set <= '0;
    command_push <= 1'b0;
    paper_start <= 1'b0;
    if (accepted && !rst) begin
      case (place)
        registers_package::TRIGGER: {watchdog_kick, latch_clear, latch, abort_now} <= reg_write_data[3:0];
        registers_package::ERROR: error_clear <= reg_write_data[4:0];
        registers_package::POSITION_SET: position_set <= reg_write_data[AXES-1:0];
        registers_package::COMMAND_PUSH: command_push <= 1'b1;
        registers_package::PAPER_START: paper_start <= HAS_PAPER && reg_write_data[0];
        default: ;
      endcase
    end
  end

  // What a write sets.
  always_ff @(posedge clk) begin
    if (accepted) begin
      case (place)
        registers_package::CONTROL: {probe_enable, hold_register} <= reg_write_data[1:0];
        registers_package::INTERRUPT_ENABLE: interrupt_enable <= reg_write_data[3:0];
        registers_package::WATERMARK: watermark <= reg_write_data[DEPTH_LOG2:0];
        registers_package::PRESCALE: prescale <= reg_write_data[15:0];
        registers_package::WATCHDOG_PERIOD: watchdog_period <= reg_write_data;
        registers_package::AXIS: axis <= reg_write_data[2:0];
        registers_package::POSITION_VALUE: position_set_value <= reg_write_data[POSITION_WIDTH-1:0];
        registers_package::STEP_TIMES:
        for (int i = 0; i < AXES; i = i + 1) begin
          if (axis == 3'(i)) begin
            step_length[i*TIME_WIDTH+:TIME_WIDTH] <= reg_write_data[TIME_WIDTH-1:0];
            step_space[i*TIME_WIDTH+:TIME_WIDTH]  <= reg_write_data[16+:TIME_WIDTH];
          end
        end
        registers_package::DIRECTION_TIMES:
        for (int i = 0; i < AXES; i = i + 1) begin
          if (axis == 3'(i)) begin
            direction_setup[i*TIME_WIDTH+:TIME_WIDTH] <= reg_write_data[TIME_WIDTH-1:0];
            direction_hold[i*TIME_WIDTH+:TIME_WIDTH]  <= reg_write_data[16+:TIME_WIDTH];
          end
        end
        default: ;
      endcase
    end
    if (rst) begin
      {probe_enable, hold_register} <= 2'b00;
      interrupt_enable <= 4'd0;
      watermark <= '0;
      prescale <= 16'd0;
      watchdog_period <= 32'd0;
      axis <= 3'd0;
      position_set_value <= '0;
      step_length <= '0;
      step_space <= '0;
      direction_setup <= '0;
      direction_hold <= '0;
    end
  end

  // The command that is being written.
  always_ff @(posedge clk) begin
    if (accepted) begin
      case (place)
        registers_package::COMMAND_COUNT: command_count <= reg_write_data[WIDTH-1:0];
        registers_package::COMMAND_FEED_LOW: command_feed[31:0] <= reg_write_data;
        registers_package::COMMAND_FEED_HIGH: command_feed[FEED_WIDTH:32] <= reg_write_data[FEED_WIDTH-32:0];
        registers_package::COMMAND_STRAIGHT_FEED_LOW: command_feed_straight[31:0] <= reg_write_data;
        registers_package::COMMAND_STRAIGHT_FEED_HIGH:
        command_feed_straight[FEED_WIDTH:32] <= reg_write_data[FEED_WIDTH-32:0];
        registers_package::COMMAND_SOURCE: command_source <= reg_write_data[4*AXES-1:0];
        registers_package::COMMAND_PUSH: begin
          command_backward <= reg_write_data[AXES-1:0];
          command_curve <= reg_write_data[registers_package::COMMAND_PUSH_CURVE_BIT+:2];
          command_dwell <= reg_write_data[registers_package::COMMAND_PUSH_DWELL_BIT];
          command_final <= reg_write_data[registers_package::COMMAND_PUSH_FINAL_BIT];
          command_tag <= reg_write_data[registers_package::COMMAND_PUSH_TAG_BIT+:16];
        end
        default:
        for (int u = 0; u < UNITS; u = u + 1) begin
          if (is_of(place, registers_package::UNIT_DECISION, registers_package::UNIT_DECISION_STRIDE, u))
            command_decision[u*UNIT_WIDTH+:UNIT_WIDTH] <= reg_write_data[UNIT_WIDTH-1:0];
          if (is_of(place, registers_package::UNIT_STRAIGHT, registers_package::UNIT_STRAIGHT_STRIDE, u))
            command_straight[u*UNIT_WIDTH+:UNIT_WIDTH] <= reg_write_data[UNIT_WIDTH-1:0];
          if (is_of(place, registers_package::UNIT_DIAGONAL, registers_package::UNIT_DIAGONAL_STRIDE, u))
            command_diagonal[u*UNIT_WIDTH+:UNIT_WIDTH] <= reg_write_data[UNIT_WIDTH-1:0];
        end
      endcase
    end
    if (rst) begin
      command_count <= '0;
      command_feed <= '0;
      command_feed_straight <= '0;
      command_source <= '0;
      command_backward <= '0;
      command_curve <= 2'b00;
      command_dwell <= 1'b0;
      command_final <= 1'b0;
      command_tag <= 16'd0;
      command_decision <= '0;
      command_straight <= '0;
      command_diagonal <= '0;
    end
  end

  // What the paper's interpolators are to make.
  always_ff @(posedge clk) begin
    if (accepted && HAS_PAPER) begin
      case (place)
        registers_package::PAPER_START_X: paper_start_x <= reg_write_data;
        registers_package::PAPER_START_Z: paper_start_z <= reg_write_data;
        registers_package::PAPER_END_X: paper_end_x <= reg_write_data;
        registers_package::PAPER_END_Z: paper_end_z <= reg_write_data;
        registers_package::PAPER_METHOD: {paper_clockwise, paper_method} <= {reg_write_data[4], reg_write_data[1:0]};
        default: ;
      endcase
    end
    if (rst) begin
      paper_start_x <= 32'd0;
      paper_start_z <= 32'd0;
      paper_end_x <= 32'd0;
      paper_end_z <= 32'd0;
      {paper_clockwise, paper_method} <= 3'd0;
    end
  end
endmodule
