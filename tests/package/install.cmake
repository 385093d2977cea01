# Installs into an empty folder, so that nothing of an earlier build can hide what is missing.
# usage: cmake -DBUILD=DIR -DPREFIX=DIR -P install.cmake
file(REMOVE_RECURSE "${PREFIX}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PREFIX}" COMMAND_ERROR_IS_FATAL ANY)
