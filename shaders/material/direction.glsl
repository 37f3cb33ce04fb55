// Unit vector along d, of any length that floats hold: d is divided by its largest component first, because squares leave the range
// of floats from 1e-19 and 1e19 on. At d = 0, a surface in the eye itself, any direction will do.
vec3 directionOf(vec3 d)
{
    float largest = max(max(abs(d.x), abs(d.y)), abs(d.z));
    return largest > 0.0 ? normalize(d / largest) : vec3(0.0, 0.0, 1.0);
}
