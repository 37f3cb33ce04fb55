#!/usr/bin/env python3
"""The numbers of source_models.cpp, from the formulas of docs/sources.md in Python's doubles: one point, every source system."""
import math


def norm(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def mix(a, b, t):
    return a * (1 - t) + b * t


def fresnel(f0, c):
    return f0 + (1 - f0) * (1 - c) ** 5


pi = math.pi
n, v, l = [0, 0, 1], norm([0.3, 0.1, 0.8]), norm([-0.4, 0.2, 0.7])
h = norm([a + b for a, b in zip(l, v)])
r, m, base = 0.3, 0.25, [0.9, 0.5, 0.1]
a = r * r
nv, nl, nh, vh, lh = dot(n, v), dot(n, l), dot(n, h), dot(v, h), dot(l, h)


def show(name, f):
    print(name, [f(c) for c in base])


def schlick_g(k):
    return (nv / (nv * (1 - k) + k)) * (nl / (nl * (1 - k) + k))


def ue4(c, double=False):
    D = r**2 / max(pi * (nh**2 * (r**2 - 1) + 1) ** 2, 1e-4)
    F = fresnel(mix(0.04, c, m), vh)
    specular = D * F * schlick_g((r + 1) ** 2 / 8) / max(4 * nv * nl, 1e-4)
    return (1 - F) * (1 - m) * c / pi + specular * (F if double else 1)


def phong(c):
    R = [2 * nl * x - y for x, y in zip(n, l)]
    return c * (0.1 + nl) + 0.5 * max(dot(R, v), 0) ** ((2 / r**4 - 2) / 4)


def groove():
    return min(1, 2 * nh * nv / vh, 2 * nh * nl / vh)


def cook_torrance(c, denominator=4, sketch=False):
    D = math.exp(-(1 - nh**2) / nh**2 / a**2) / (pi * a**2 * nh**4)
    F = fresnel(mix(0.04, c, m), vh)
    specular, diffuse = D * F * groove() / (denominator * nl * nv), (1 - F) * (1 - m) * c / pi
    return diffuse * nl + specular / nl if sketch else diffuse + specular


ggx = a**2 / (pi * (nh**2 * (a**2 - 1) + 1) ** 2)


def ggx_burley(c):
    F, f90 = fresnel(mix(0.5, c, m), lh), 0.5 + 2 * a * lh**2
    burley = (1 + (f90 - 1) * (1 - nl) ** 5) * (1 + (f90 - 1) * (1 - nv) ** 5) / pi
    return ggx * F * schlick_g((r + 1) ** 2 / 8) / (4 * nl * nv + 1e-6) + (1 - m) * c * burley


def schlick_beckmann(c, double=False):
    F = fresnel(mix(0.04, c, m), vh)
    return ggx * F * (F if double else 1) * schlick_g(a / 2) / max(4 * nl * nv, 1e-6) + (1 - F) * c / pi


def smith_r(c):
    def g1(x):
        return 2 * x / (x + math.sqrt(r**2 + (1 - r**2) * x**2))

    return ggx * fresnel(mix(0.04, c, m), vh) * g1(nv) * g1(nl) / (4 * nl * nv) + c


def torrance_sparrow(c, reflectivity=1):
    s = 2 / r**4 - 2
    F = fresnel(mix(0.04, 1, m), vh)
    brdf = (s + 2) / (2 * pi) * nh**s * groove() * F / (4 * nl * nv)
    diffuse = c / pi * abs(nl)
    dielectric, metal = brdf * nl + (1 - F) * diffuse, brdf * c * nl
    return mix(diffuse, mix(dielectric, metal, m), reflectivity) / nl


show("ue4-direct", ue4)
show("ue4-direct, double-fresnel", lambda c: ue4(c, True))
show("phong", phong)
show("cook-torrance-beckmann", cook_torrance)
show("cook-torrance-beckmann, pi-denominator", lambda c: cook_torrance(c, pi))
show("cook-torrance-beckmann, energy-sketch", lambda c: cook_torrance(c, sketch=True))
show("ggx-burley", ggx_burley)
show("schlick-beckmann", schlick_beckmann)
show("schlick-beckmann, double-fresnel", lambda c: schlick_beckmann(c, True))
show("smith-r", smith_r)
show("torrance-sparrow-blinn", torrance_sparrow)
show("torrance-sparrow-blinn, reflectivity=0.3", lambda c: torrance_sparrow(c, 0.3))
