// Marks the pixels that something covers, seen or hidden.
layout(location = 0) out vec4 outMark;

void main()
{
    outMark = vec4(1.0);
}
