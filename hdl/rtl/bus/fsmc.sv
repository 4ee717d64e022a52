// Between the memory bus of an STM32F4 (FSMC, asynchronous SRAM, 16 bits) and the registers.
//
//   NE   ‾\__________/‾     A and NBL stand while NE and NWE, or NOE, are low; D is taken where NWE rises.
//   NWE  ‾‾‾\_____/‾‾‾‾     NWE low ≥ 3 clocks, high ≥ 2 between two writes.
//   NOE  ‾‾‾\_______/‾‾     D is driven while NE and NOE are low, and valid 6 clocks after NOE falls, or where NWAIT rises.
//                           NOE high ≥ 3 clocks between two reads.
//
// Nothing of the bus is synchronous to clk: all inputs go through two flip-flops, and what stood at the last clock at
// which NWE was seen low is what is written. NWE must be seen low at two clocks: what is shorter is a glitch.
//
// A register is two halfwords, the low one at the lower address. A write of the low one waits here; that of the high one
// writes both, if the low one of the same register was the last to be written. Else, or where NBL masks a byte, the
// register file gets a write of less than four bytes, which it refuses. A read of the low halfword reads the register
// and keeps both halves; that of the high one gives what was kept, if it is of the same register, else it reads anew.
module fsmc (
    input logic clk,
    input logic rst,  // synchronous

    input  logic        NE,   // all low active
    input  logic        NOE,
    input  logic        NWE,
    input  logic [ 1:0] NBL,
    input  logic [ 8:1] A,    // of halfwords: the processor's A[7:0] with a bus of 16 bits
    input  logic [15:0] D_in,
    output logic [15:0] D_out,
    output logic        D_drive,  // the pins are driven with D_out
    output logic        NWAIT,    // low: the data of a read are not there yet

    output logic        reg_write,
    output logic        reg_read,
    output logic [ 8:2] reg_address,
    output logic [31:0] reg_write_data,
    output logic [ 3:0] reg_write_strobe,
    input  logic [31:0] reg_read_data
);
  // Two flip-flops, and one clock more for edges.
  logic [2:0] writes, reads;  // NE and NWE, NE and NOE are low; bit 2 the oldest
  logic [7:0] address_1, address_2, address_3;
  logic [1:0] mask_1, mask_2, mask_3;
  logic [15:0] data_1, data_2, data_3;
  logic was_low_twice;

  always_ff @(posedge clk) begin
    writes <= rst ? 3'b000 : {writes[1:0], !NE && !NWE};
    reads <= rst ? 3'b000 : {reads[1:0], !NE && !NOE};
    {address_3, address_2, address_1} <= {address_2, address_1, A};
    {mask_3, mask_2, mask_1} <= {mask_2, mask_1, NBL};
    {data_3, data_2, data_1} <= {data_2, data_1, D_in};
    was_low_twice <= !rst && writes[1] && writes[2];
  end

  logic write_ends, read_begins;
  assign write_ends = writes[2] && !writes[1] && was_low_twice;
  assign read_begins = reads[1] && !reads[2];

  // The low halfword that waits, and of which register.
  logic [15:0] low_data;
  logic [1:0] low_strobe;
  logic [6:0] low_address;
  logic is_pair;
  assign is_pair = low_address == address_3[7:1];

  // The register that was read last; its high halfword is still to be fetched.
  logic [31:0] kept;
  logic [6:0] kept_address;
  logic has_kept, fetches, is_ready;

  always_ff @(posedge clk) begin
    reg_write <= 1'b0;
    reg_read <= 1'b0;
    fetches <= reg_read;
    if (write_ends) begin
      low_strobe <= 2'b00;
      if (!address_3[0]) begin
        low_data <= data_3;
        low_strobe <= ~mask_3;
        low_address <= address_3[7:1];
      end else begin
        reg_write <= 1'b1;
        reg_address <= address_3[7:1];
        reg_write_data <= {data_3, low_data};
        reg_write_strobe <= {~mask_3, is_pair ? low_strobe : 2'b00};
      end
    end
    if (read_begins) begin
      if (address_2[0] && has_kept && kept_address == address_2[7:1]) begin
        has_kept <= 1'b0;
        is_ready <= 1'b1;
      end else begin
        reg_read <= 1'b1;
        reg_address <= address_2[7:1];
        kept_address <= address_2[7:1];
        has_kept <= !address_2[0];
      end
    end
    if (fetches) begin
      kept <= reg_read_data;
      is_ready <= 1'b1;
    end
    if (!reads[1]) is_ready <= 1'b0;
    if (rst) begin
      reg_write <= 1'b0;
      reg_read <= 1'b0;
      fetches <= 1'b0;
      low_strobe <= 2'b00;
      has_kept <= 1'b0;
      is_ready <= 1'b0;
    end
  end

  logic is_high;  // the halfword that is read
  always_ff @(posedge clk) if (read_begins) is_high <= address_2[0];

  assign D_drive = !NE && !NOE;
  assign D_out = is_high ? kept[31:16] : kept[15:0];
  assign NWAIT = !D_drive || is_ready;
endmodule
