// expect rmse 2e-5 but for 7 pixels: POV-Ray keeps vertices in single precision, which moves edges
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 adc_bailout 1e-4 }
camera { location <0.3, 1.6, -5> look_at <0, 0.6, 0> right x*image_width/image_height angle 40 }
light_source { <4, 6, -5> rgb 0.8 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.7, 0.6> rgb <0.2, 0.3, 0.4> scale 0.5 } finish { ambient 0.1 diffuse 0.6 } }
mesh2 {
  vertex_vectors { 5, <-0.7,0.2,0>, <0.7,0.2,0>, <0.7,1.4,0>, <-0.7,1.4,0>, <0,0.8,-0.5> }
  normal_vectors { 5, <-1,-1,-1>, <1,-1,-1>, <1,1,-1>, <-1,1,-1>, <0,0,-1> }
  face_indices { 4, <0,1,4>, <1,2,4>, <2,3,4>, <3,0,4> }
  pigment { rgb <0.7, 0.7, 0.4> } finish { phong 0.7 phong_size 20 reflection 0.2 }
}
