# The paper's cores: width 6 for all arcs, 24 for large ones, 6 in the first quadrant alone.
leadscrew_model(Vdigital_integrator TOP digital_integrator SOURCES paper/digital_integrator.sv PARAMETERS WIDTH=6)
leadscrew_model(Vstrict_integrator TOP digital_integrator SOURCES paper/digital_integrator.sv
  PARAMETERS WIDTH=6 "STRICT=1'b1")
set(search_sources paper/arc_search.sv paper/arc_entry.sv paper/arc_quadrant.sv)
set(dda_sources paper/arc_entry.sv paper/arc_quadrant.sv)
foreach(core by_point_comparison minimum_error improved_minimum_error dda)
  set(sources paper/${core}.sv ${search_sources})
  if(core STREQUAL "dda")
    set(sources paper/dda.sv ${dda_sources})
  endif()
  leadscrew_model(V${core}_6 TOP ${core} SOURCES ${sources} PARAMETERS WIDTH=6)
  leadscrew_model(V${core}_24 TOP ${core} SOURCES ${sources} PARAMETERS WIDTH=24)
  leadscrew_model(V${core}_first TOP ${core} SOURCES ${sources} PARAMETERS WIDTH=6 "FIRST_QUADRANT=1'b1")
endforeach()
set(koren_sources paper/koren_hw.sv paper/digital_integrator.sv)
leadscrew_model(Vkoren_hw TOP koren_hw SOURCES ${koren_sources})
leadscrew_model(Vkoren_hw_carry TOP koren_hw SOURCES ${koren_sources} PARAMETERS "STRICT=1'b0")
leadscrew_model(Vlecture_dda TOP lecture_dda SOURCES paper/lecture_dda.sv paper/up_down_counter.sv
  paper/digital_integrator.sv)
leadscrew_model(Vlecture_timer TOP digital_integrator SOURCES paper/digital_integrator.sv PARAMETERS WIDTH=13)
leadscrew_model(Vup_down_counter TOP up_down_counter SOURCES paper/up_down_counter.sv PARAMETERS WIDTH=4)
leadscrew_bench(paper SOURCES sim/test_digital_integrator.cpp sim/test_arcs.cpp sim/test_waveforms.cpp
  sim/test_waveform_pictures.cpp sim/waveform_picture.cpp sim/test_koren_hw.cpp sim/test_lecture_dda.cpp sim/test_paper_vectors.cpp
  ROOMS markup)
