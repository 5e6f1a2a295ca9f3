// A union of two slabs that overlap, with one interior: POV-Ray takes the second entry for a leave.
// pixel 60, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
camera { location -5*z look_at 0 right 4/3*x angle 30 }
plane { -z, -4 pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } scale 8 translate -4*x } finish { ambient 0 diffuse 0 emission 1 } }
union {
    box { <-9, -9, -1>, <9, 9, 0.2> }
    box { <-9, -9, -0.2>, <9, 9, 1> }
    pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
    interior { ior 2 }
}
