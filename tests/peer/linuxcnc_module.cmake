cmake_minimum_required(VERSION 3.25)
# Builds the planner module of LinuxCNC (integrations/linuxcnc) on the package that this build installs.
#   -D BUILD=… -D SOURCES=… -D SCRATCH=… -D COMPILER=… -D FLAGS=…
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
endfunction()
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/installed)
run(${CMAKE_COMMAND} -S ${SOURCES}/integrations/linuxcnc -B ${SCRATCH}/module -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=ON
  -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}" -DCMAKE_PREFIX_PATH=${SCRATCH}/installed)
run(${CMAKE_COMMAND} --build ${SCRATCH}/module)
