// expect rmse 1e-3: single pixels on the edges of a pattern fall to the other side by rounding
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 adc_bailout 1e-4 }
camera { location <0.3, 2.2, -5> look_at <0, 0.3, 0> right x*image_width/image_height angle 40 }
light_source { <4, 6, -5> rgb 0.8 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, 0 pigment { gradient x color_map { [0 rgb 0.1] [0.4 rgb <0.9,0.5,0.2>] [0.4 rgb <0.2,0.5,0.9>] [1 rgb 1] } scale 0.7 } }
sphere { <-0.8, 0.8, 0>, 0.7 pigment { gradient <1,1,0> color_map { [0 rgb 0] [1 rgb 1] } frequency 3 phase 0.2 triangle_wave } }
box { <0.2, 0.1, -0.5>, <1.3, 1.2, 0.5> rotate 20*y pigment { gradient y pigment_map { [0.2 checker rgb 1 rgb 0 scale 0.1] [0.8 rgb <0.5,0.2,0.7>] } sine_wave scale 0.8 } }
