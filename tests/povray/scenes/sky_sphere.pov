// expect rmse 1e-5: rounding to 16 bits is 4.4e-6
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 adc_bailout 1e-4 }
camera { location <0.3, 1.6, -5> look_at <0, 0.6, 0> right x*image_width/image_height angle 40 }
light_source { <4, 6, -5> rgb 0.8 }
background { rgb <0.1,0.5,0.1> } sky_sphere { pigment { gradient y color_map { [0 rgb <0.9,0.7,0.5>] [0.6 rgb <0.3,0.5,0.9>] [1 rgbt <0.1,0.1,0.5,0.5>] } } pigment { gradient x color_map { [0 rgbt <1,1,1,1>] [1 rgbt <0.8,0.2,0.2,0.4>] } scale 2 translate -x } rotate 20*z }
sphere { <-0.9, 0.5, 0>, 0.5 pigment { rgb <0.8, 0.3, 0.2> } }
box { <0.2, 0, -0.4>, <1, 0.9, 0.4> pigment { rgb <0.3, 0.6, 0.3> } }
