# Installs libsg from BUILD into a folder of its own, then builds and runs the consumer against it:
# by the CMake package with the static and the shared library, and by pkg-config.
#     cmake -D BUILD=... -D SOURCE=... -D WORK=... -D CONFIG=... -D CC=... -P run.cmake
function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output
        ERROR_VARIABLE output)
    if(NOT status EQUAL 0)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
    endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed --component sg)
file(GLOB files RELATIVE ${WORK}/installed ${WORK}/installed/include/*)
if(NOT files STREQUAL "include/sg.h")
    message(FATAL_ERROR "expected the one public header, found ${files}")
endif()

foreach(target sg::sg sg::sg_shared)
    string(MAKE_C_IDENTIFIER ${target} name)
    run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/${name} -D SG_TARGET=${target}
        -D CMAKE_PREFIX_PATH=${WORK}/installed -D CMAKE_BUILD_TYPE=${CONFIG})
    run(${CMAKE_COMMAND} --build ${WORK}/${name})
    run(${WORK}/${name}/consumer)
endforeach()

find_program(PKG_CONFIG NAMES pkg-config pkgconf)
if(PKG_CONFIG)
    file(GLOB_RECURSE pc ${WORK}/installed/*.pc)
    cmake_path(GET pc PARENT_PATH pc_dir)
    cmake_path(GET pc_dir PARENT_PATH lib_dir)
    set(ENV{PKG_CONFIG_PATH} ${pc_dir})
    execute_process(COMMAND ${PKG_CONFIG} --cflags --libs sg OUTPUT_VARIABLE flags
        OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(flags UNIX_COMMAND "${flags}")
    run(${CXX} -c ${SOURCE}/header.cc -I${WORK}/installed/include -o ${WORK}/header.o)
    run(${CC} ${SOURCE}/consumer.c ${WORK}/header.o -o ${WORK}/by_pkg_config ${flags} -lm)
    run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${lib_dir} ${WORK}/by_pkg_config)
    execute_process(COMMAND ${PKG_CONFIG} --static --libs sg OUTPUT_VARIABLE static_flags)
    if(NOT static_flags MATCHES "-lm")
        message(FATAL_ERROR "pkg-config --static does not name libm: ${static_flags}")
    endif()
endif()
