# How the registry's units are compiled; include() it where the sources are listed.
#
# -fno-math-errno and -fno-trapping-math change no value: they let the batch loops turn `?:` into
# selections and call the vector library. -fno-tree-pre keeps the clamps of SG_exp and SG_exp2 in
# front of the calls that they are for (it would see that the clamped call's value is known, and in
# a vector make the call without the clamp): batches are three times as fast. -fopenmp-simd reads the loops' pragma and needs no
# OpenMP runtime. -fexcess-precision=16 makes _Float16 round at every operation.
include(CheckCCompilerFlag)
include(CheckCSourceCompiles)

set(SG_METHOD_OPTIONS "")
foreach(flag -fno-math-errno -fno-trapping-math -fno-tree-pre -fopenmp-simd)
    string(MAKE_C_IDENTIFIER "SG_FLAG${flag}" known)
    check_c_compiler_flag(${flag} ${known})
    if(${known})
        list(APPEND SG_METHOD_OPTIONS ${flag})
    endif()
endforeach()
if(SG_FLAG_fopenmp_simd)
    list(APPEND SG_METHOD_OPTIONS -DSG_SIMD)
endif()
set_source_files_properties(methods_f64.c methods_f32.c PROPERTIES
    COMPILE_OPTIONS "${SG_METHOD_OPTIONS}")

check_c_compiler_flag(-fexcess-precision=16 SG_EXCESS_PRECISION_16)
if(SG_EXCESS_PRECISION_16)
    set(CMAKE_REQUIRED_FLAGS -fexcess-precision=16)
    check_c_source_compiles(
        "_Float16 f(_Float16 x) { return x * x; } int main(void) { return (int)f((_Float16)0); }"
        SG_HALF)
    unset(CMAKE_REQUIRED_FLAGS)
endif()
if(SG_HALF)
    # -Wno-overflow: literals beyond half's range are meant to become infinite there.
    set_source_files_properties(methods_f16.c PROPERTIES COMPILE_OPTIONS
        "-fexcess-precision=16;-Wno-overflow;-DSG_HAVE_F16")
    set_source_files_properties(method.c PROPERTIES COMPILE_DEFINITIONS SG_HAVE_F16)
else()
    message(STATUS "no _Float16 here: methods have no half precision")
endif()
