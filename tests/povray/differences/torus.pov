// A torus of glass that closes over its hole: to POV-Ray there is a hollow within, where the ring reaches over the axis.
// pixel 60, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
camera { orthographic location -5*z direction z right 4/3*x up y }
plane { -z, -4 pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } scale 8 translate -4*x } finish { ambient 0 diffuse 0 emission 1 } }
torus { 0.6, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.3 } }
