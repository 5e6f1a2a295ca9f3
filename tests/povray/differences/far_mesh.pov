// A square whose right edge is at 100000.003: POV-Ray holds vertices in single precision, and the edge is at 100000 to it.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
camera { orthographic location <1e5 + 0.0015, 0, -5> direction z right 4/3*x up y }
mesh {
    triangle { <99999, -1, 0>, <100000.003, -1, 0>, <100000.003, 1, 0> }
    triangle { <99999, -1, 0>, <100000.003, 1, 0>, <99999, 1, 0> }
    pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 }
}
