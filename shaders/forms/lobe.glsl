// method: standard
// The vector entry points of sg.glsl: thin wrappers around the scalar helpers, plain GLSL.
// `sgfit emit` puts the name of a method where sg_irradiance asks for one.

// A spherical Gaussian amplitude * exp(sharpness * (dot(w, axis) - 1)). axis: unit length.
// sharpness: lambda, in [0, 1e37]; 0 is a constant, larger is narrower. amplitude: the value at the
// axis, for each colour channel.
struct sg_lobe {
    vec3 axis;
    float sharpness;
    vec3 amplitude;
};

// The lobe's value in a direction of unit length, in [0, amplitude]; accurate next to the axis at
// any sharpness.
vec3 sg_evaluate_lobe(sg_lobe lobe, vec3 direction)
{
    vec3 difference = direction - lobe.axis;
    return lobe.amplitude * sg_evaluate_near(lobe.sharpness, dot(difference, difference));
}

// The product of two lobes, which is a lobe again. Sharpnesses in [0, 1e37]. Where the product is
// constant (opposite axes, equal sharpness) its sharpness is 0 and its axis perpendicular to both.
// Source: Xu et al. 2014; Meder and Bruederlin 2018, eq. 3.
sg_lobe sg_product(sg_lobe a, sg_lobe b)
{
    vec3 sum = a.axis + b.axis;
    vec3 difference = a.axis - b.axis;
    float total = a.sharpness + b.sharpness;
    float lean = total > 0.0 ? (a.sharpness - b.sharpness) / total : 0.0;
    vec3 axis = 0.5 * sum + 0.5 * lean * difference;
    float size = length(axis);
    vec3 other = abs(a.axis.z) < 0.5 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    sg_lobe product;
    product.axis = size > 0.0 ? axis / size : normalize(cross(a.axis, other));
    product.sharpness = sg_product_sharpness(a.sharpness, b.sharpness, dot(sum, sum));
    product.amplitude = a.amplitude * b.amplitude *
        exp(sg_product_log_amplitude(a.sharpness, b.sharpness, product.sharpness,
                                     dot(difference, difference)));
    return product;
}

// The lobe's integral over the sphere: amplitude times 2 pi (1 - e^-2lambda)/lambda, 4 pi at 0.
vec3 sg_integrate_lobe(sg_lobe lobe)
{
    return lobe.amplitude * sg_integral(lobe.sharpness);
}

// Irradiance of a surface from one lobe of light: the integral of the lobe times
// max(dot(w, normal), 0) over the sphere, in [0, pi amplitude] up to the method's error. For a
// Lambertian surface the outgoing radiance is albedo/pi times this. axis and normal: unit length;
// sharpness: the method's domain, see sg_A_h_@METHOD@ above.
vec3 sg_irradiance(vec3 amplitude, vec3 axis, float sharpness, vec3 normal)
{
    return amplitude * sg_A_h_@METHOD@(sharpness, clamp(dot(axis, normal), -1.0, 1.0));
}
