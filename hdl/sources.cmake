# What leadscrew_fsmc and the other tops are made of, from the folder hdl/rtl; those of buses by their name.
set(LEADSCREW_CORE_SOURCES registers_package.sv registers.sv motion_core.sv engine.sv command_fifo.sv decision_unit.sv
  position_counter.sv step_shaper.sv leadscrew_core.sv)
set(LEADSCREW_FSMC_SOURCES ${LEADSCREW_CORE_SOURCES} bus/fsmc.sv leadscrew_fsmc.sv)
set(LEADSCREW_AXI_SOURCES ${LEADSCREW_CORE_SOURCES} bus/axi4_lite.sv leadscrew_axi.sv)
set(LEADSCREW_WISHBONE_SOURCES ${LEADSCREW_CORE_SOURCES} bus/wishbone.sv leadscrew_wishbone.sv)
# What PAPER_WIDTH > 0 needs beside.
set(LEADSCREW_PAPER_SOURCES paper/arc_entry.sv paper/arc_quadrant.sv paper/arc_search.sv paper/by_point_comparison.sv paper/dda.sv
  paper/minimum_error.sv paper/improved_minimum_error.sv paper_interpolators.sv)
