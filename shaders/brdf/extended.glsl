// Numbers as the unevaluated sum of two floats, vec2(high, low), about 48 bits: for exponents of up to 100, whose own rounding would
// show in the result a hundredfold. Dekker, A Floating-Point Technique for Extending the Available Precision, 1971. `precise` keeps
// compilers from simplifying what is zero on paper; no fused multiply-add is assumed.
#ifndef TORRANCE_BRDF_EXTENDED
#define TORRANCE_BRDF_EXTENDED

// Where exp(-x) times any density's peak (3.2e7) is below the least normal float.
const float kExponentUnderflow = 110.0;

// a + b exactly.
vec2 exactSum(float a, float b)
{
    precise float sum = a + b;
    precise float fromB = sum - a;
    precise float low = (a - (sum - fromB)) + (b - fromB);
    return vec2(sum, low);
}

// a * b exactly, |a|, |b| < 1e34: each factor is cut into 12 bits and the rest.
vec2 exactProduct(float a, float b)
{
    const float cut = 4097.0; // 2^12 + 1
    precise float ca = cut * a;
    precise float cb = cut * b;
    precise float aHigh = ca - (ca - a);
    precise float bHigh = cb - (cb - b);
    precise float aLow = a - aHigh;
    precise float bLow = b - bHigh;
    precise float product = a * b;
    precise float low = ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow;
    return vec2(product, low);
}

vec2 extendedSum(vec2 a, vec2 b)
{
    vec2 sum = exactSum(a.x, b.x);
    precise float low = sum.y + (a.y + b.y);
    return exactSum(sum.x, low);
}

vec2 extendedProduct(vec2 a, vec2 b)
{
    vec2 product = exactProduct(a.x, b.x);
    precise float low = product.y + (a.x * b.y + a.y * b.x);
    return exactSum(product.x, low);
}

vec2 extendedQuotient(vec2 a, vec2 b)
{
    precise float quotient = a.x / b.x;
    vec2 back = exactProduct(quotient, b.x);
    precise float rest = ((a.x - back.x) - back.y) + a.y - quotient * b.y;
    precise float low = rest / b.x;
    return exactSum(quotient, low);
}

// a^2 + b^2 - 1 with the rounding of its result only.
float squaresLessOne(float a, float b)
{
    vec2 a2 = exactProduct(a, a);
    vec2 b2 = exactProduct(b, b);
    return extendedSum(extendedSum(a2, vec2(-1.0, 0.0)), b2).x;
}

// 2^n, n in [-126, 127].
float powerOfTwo(int n)
{
    return uintBitsToFloat(uint(n + 127) << 23);
}

// ln 2 as a number of 10 bits, whose products with small integers are exact, and the rest.
const float kLn2High = 0.693359375;
const float kLn2Low = -2.12194440e-4;

// log(x), 1e-37 < x <= 1: x = 2^e (1 + f), log(1 + f) = 2 artanh(z), z = f / (2 + f), |z| <= 0.172. Only the first term of the series
// needs both words: the others are a hundredth of it.
vec2 extendedLog(vec2 x)
{
    float e = round(log2(x.x));
    vec2 f = extendedSum(x * powerOfTwo(-int(e)), vec2(-1.0, 0.0));
    vec2 z = extendedQuotient(f, extendedSum(f, vec2(2.0, 0.0)));
    float z2 = z.x * z.x;
    float tail = z.x * z2 * (2.0 / 3.0 + z2 * (2.0 / 5.0 + z2 * (2.0 / 7.0 + z2 * (2.0 / 9.0 + z2 * (2.0 / 11.0)))));
    vec2 series = extendedSum(2.0 * z, vec2(tail, 0.0));
    vec2 whole = exactSum(e * kLn2High, e * kLn2Low);
    return extendedSum(series, whole);
}

// scale * exp(-x), 0 <= x < kExponentUnderflow; the power of two goes on in two halves, so that a large scale saves a small exponential.
float scaledExp(float scale, vec2 x)
{
    float n = round(-x.x / (kLn2High + kLn2Low));
    precise float rest = ((-x.x - n * kLn2High) - n * kLn2Low) - x.y;
    int half1 = int(n) / 2;
    return scale * exp(rest) * powerOfTwo(half1) * powerOfTwo(int(n) - half1);
}

#endif
