cmake_minimum_required(VERSION 3.25)
# Builds the planner module of LinuxCNC (integrations/linuxcnc) on the package that this build installs.
#   -D BUILD=… -D SOURCES=… -D SCRATCH=… -D COMPILER=… -D FLAGS=…
include(${CMAKE_CURRENT_LIST_DIR}/../house/run.cmake)
# What an earlier build installed elsewhere is not found.
file(REMOVE_RECURSE ${SCRATCH}/installed)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/installed)
run(${CMAKE_COMMAND} -S ${SOURCES}/integrations/linuxcnc -B ${SCRATCH}/module -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=ON
  -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}" -DCMAKE_PREFIX_PATH=${SCRATCH}/installed)
run(${CMAKE_COMMAND} --build ${SCRATCH}/module)
