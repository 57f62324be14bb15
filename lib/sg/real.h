/* real.h: what the generated form texts (tables/out/forms.inc) mean at one precision.
 *
 * Private to the methods_*.c units and bench/stability_long.c. A unit defines SG_PRECISION (64, 32,
 * 16, or 80 for long double) and includes this:
 *   SG_REAL     the type that `real` of a form stands for
 *   SG_K(x)     the literal x in that type
 *   SG_NAME(x)  the name x with the precision's suffix
 *   SG_INLINE   how the texts' functions are declared
 *   SG_exp ...  GLSL's built-in functions at that precision
 *
 * Every operation rounds to SG_REAL: half needs -fexcess-precision=16 for that (methods.cmake). */
#ifndef SG_REAL_H
#define SG_REAL_H

#include <math.h>
#include <stdbool.h>

#define SG_PASTE_(a, b) a##b
#define SG_PASTE(a, b)  SG_PASTE_(a, b)

#if SG_PRECISION == 64
typedef double sg_real;
#define SG_SUFFIX     _f64
#define SG_LIBM(name) name
#elif SG_PRECISION == 32
typedef float sg_real;
#define SG_SUFFIX     _f32
#define SG_LIBM(name) name##f
#elif SG_PRECISION == 16
typedef _Float16 sg_real;
#define SG_SUFFIX     _f16
/* In half the C library's float function, rounded: correctly rounded but for rare ties. */
#define SG_LIBM(name) name##f
#elif SG_PRECISION == 80
typedef long double sg_real;
#define SG_SUFFIX     _f80
#define SG_LIBM(name) name##l
#else
#error "SG_PRECISION is 80, 64, 32 or 16"
#endif

#define SG_REAL    sg_real
#define SG_K(x)    ((sg_real)(x))
#define SG_NAME(x) SG_PASTE(x, SG_SUFFIX)

/* A loop with a call left in it does not vectorise, whatever the compiler thinks of the size. */
#if defined(__GNUC__)
#define SG_INLINE static inline __attribute__((always_inline))
#else
#define SG_INLINE static inline
#endif

/* glibc's vector library serves loops over these functions, but glibc declares that only under
 * -ffast-math, which nothing here may use. The declarations change no single call. */
#if defined(SG_SIMD) && defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) &&         \
    defined(__GLIBC__)
#if __GLIBC_PREREQ(2, 22)
#define SG_VECTOR __attribute__((simd("notinbranch")))
double exp(double) SG_VECTOR;
float expf(float) SG_VECTOR;
double log(double) SG_VECTOR;
float logf(float) SG_VECTOR;
double pow(double, double) SG_VECTOR;
float powf(float, float) SG_VECTOR;
#if __GLIBC_PREREQ(2, 35)
double exp2(double) SG_VECTOR;
float exp2f(float) SG_VECTOR;
double log2(double) SG_VECTOR;
float log2f(float) SG_VECTOR;
double expm1(double) SG_VECTOR;
double erf(double) SG_VECTOR;
double erfc(double) SG_VECTOR;
#endif
#endif
#endif

#define SG_FUNCTION_1(name, libm)                                                                  \
    SG_INLINE sg_real SG_##name(sg_real x)                                                         \
    {                                                                                              \
        return (sg_real)SG_LIBM(libm)(x);                                                          \
    }

SG_FUNCTION_1(log, log)
SG_FUNCTION_1(log2, log2)
SG_FUNCTION_1(sqrt, sqrt)
SG_FUNCTION_1(floor, floor)
SG_FUNCTION_1(abs, fabs)

/* Where the result would be below the smallest normal number it is 0 (but in half), as on devices
 * that flush denormals: there the vector library falls back to single calls, twenty times slower,
 * and a sharp lobe is mostly such places. NaN passes the comparison and stays. */
#if SG_PRECISION >= 64
#define SG_EXP_MIN  -708.39
#define SG_EXP2_MIN -1021.99
#elif SG_PRECISION == 32
#define SG_EXP_MIN  -87.33
#define SG_EXP2_MIN -125.99
#endif
#if SG_PRECISION == 16
SG_FUNCTION_1(exp, exp)
SG_FUNCTION_1(exp2, exp2)
#else
/* A factor rather than `vanishes ? 0 : exp(...)`: of that the compiler makes an unclamped call. */
SG_INLINE sg_real SG_exp(sg_real x)
{
    bool vanishes = x < SG_K(SG_EXP_MIN);
    sg_real keep = vanishes ? SG_K(0.0) : SG_K(1.0);
    return SG_LIBM(exp)(vanishes ? SG_K(SG_EXP_MIN) : x) * keep;
}
SG_INLINE sg_real SG_exp2(sg_real x)
{
    bool vanishes = x < SG_K(SG_EXP2_MIN);
    sg_real keep = vanishes ? SG_K(0.0) : SG_K(1.0);
    return SG_LIBM(exp2)(vanishes ? SG_K(SG_EXP2_MIN) : x) * keep;
}
#endif

/* What may stand in for a helper (`// double: NAME`): the C library's, in double and wider, kept
 * to the arguments that its vector version serves without falling back. */
#if SG_PRECISION >= 64
SG_FUNCTION_1(erf, erf)
SG_INLINE sg_real SG_expm1(sg_real x)
{
    return SG_LIBM(expm1)(x < SG_K(-50.0) ? SG_K(-50.0) : x); /* -1 from there on */
}
SG_INLINE sg_real SG_erfc(sg_real x)
{
    bool vanishes = x > SG_K(26.5); /* below 1e-307 */
    sg_real keep = vanishes ? SG_K(0.0) : SG_K(1.0);
    return SG_LIBM(erfc)(vanishes ? SG_K(26.5) : x) * keep;
}
#endif

SG_INLINE sg_real SG_pow(sg_real x, sg_real y)
{
    return (sg_real)SG_LIBM(pow)(x, y);
}
SG_INLINE sg_real SG_inversesqrt(sg_real x)
{
    return SG_K(1.0) / SG_sqrt(x);
}

/* As GLSL defines them; ternaries, because fmax and fmin do not vectorise. */
SG_INLINE sg_real SG_min(sg_real x, sg_real y)
{
    return y < x ? y : x;
}
SG_INLINE sg_real SG_max(sg_real x, sg_real y)
{
    return x < y ? y : x;
}
SG_INLINE sg_real SG_clamp(sg_real x, sg_real low, sg_real high)
{
    return SG_min(SG_max(x, low), high);
}
SG_INLINE sg_real SG_sign(sg_real x)
{
    return x > SG_K(0.0) ? SG_K(1.0) : x < SG_K(0.0) ? SG_K(-1.0) : SG_K(0.0);
}

/* Marks the loops of the batch functions: compiled for several instruction sets where the
 * loader can choose between them, and always free to be vectorised. */
#if defined(SG_SIMD) && !defined(__clang__) /* which warns of loops that it leaves scalar */
#define SG_LOOP _Pragma("omp simd")
#else
#define SG_LOOP
#endif
#if defined(SG_SIMD) && defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) &&         \
    defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SG_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define SG_CLONES
#endif

#endif
