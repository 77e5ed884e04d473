// Made by the target update_page_constants from the program's own constants (page_constants.cpp).

// Packed numbers: no value, the largest value, the largest coordinate of a direction.
export const noLevel = 65535;
export const topLevel = 65534;
export const directionLevels = 127;
// Number of the colours of methods.
export const methodColours = 7;
// Strokes and gaps of the lines of methods.
export const methodDashes = ['none', '7 3', '2 3', '9 3 2 3', '12 4', '5 2 1 2 1 2', '3 2'];
// Triangles of a point of a cloud.
export const trianglesPerSplat = 4;
// Edges up to this angle are shaded smoothly.
export const smoothEdgeDegrees = 40;
// Light of pictures: its direction (right, up, towards the viewer), and how much a surface has of it.
export const shading = {
  light: [-0.6, 1, 0.9], wrap: 0.6, ambient: 0.36, wrapped: 0.54, frontal: 0.1,
};
// Colours of no value, and of a shape without colours.
export const unknownColour = '#a0a0a0';
export const plainColour = '#c6c6c2';
// Colour of values below a threshold.
export const belowColour = '#d62728';
// The colour map, from 0 to 1.
export const ramp = [
  '#440154', '#440355', '#450457', '#450658', '#45075a', '#45085b', '#460a5c', '#460b5e',
  '#460d5f', '#460e61', '#471062', '#471164', '#471365', '#471466', '#481568', '#481769',
  '#48186a', '#48196b', '#481b6c', '#481c6e', '#481d6f', '#481f70', '#482071', '#482172',
  '#482273', '#482474', '#482575', '#482676', '#482877', '#472978', '#472a7a', '#472b7a',
  '#472d7b', '#472e7c', '#462f7c', '#46307d', '#46327e', '#45337f', '#45347f', '#453580',
  '#453681', '#443881', '#443982', '#443a83', '#443b84', '#433d84', '#433e85', '#423f85',
  '#424085', '#414186', '#414286', '#414387', '#404587', '#404687', '#3f4788', '#3f4888',
  '#3e4989', '#3e4a89', '#3d4c89', '#3d4d8a', '#3d4e8a', '#3c4f8a', '#3c508b', '#3b518b',
  '#3b528b', '#3a538b', '#3a548b', '#39558b', '#39568c', '#38578c', '#38588c', '#375a8c',
  '#375b8c', '#365c8d', '#365d8d', '#355e8d', '#355f8d', '#34608d', '#34618d', '#33628d',
  '#33638d', '#33648d', '#32658d', '#32668e', '#31678e', '#31688e', '#30698e', '#306a8e',
  '#2f6b8e', '#2f6c8e', '#2e6d8e', '#2e6e8e', '#2e6f8e', '#2d708e', '#2d708e', '#2d718e',
  '#2c728e', '#2c738e', '#2b748e', '#2b758e', '#2b768e', '#2a778e', '#2a788e', '#29798e',
  '#297a8e', '#297b8e', '#287c8e', '#287d8e', '#287e8e', '#277f8e', '#27808e', '#26818e',
  '#26828e', '#26828e', '#25838e', '#25848e', '#25858e', '#24868e', '#24878e', '#23888e',
  '#23898e', '#238a8d', '#238b8d', '#228c8d', '#228d8d', '#228e8d', '#218f8c', '#21908c',
  '#21918c', '#21928c', '#20928c', '#20938c', '#20948b', '#1f958b', '#1f968b', '#1f978b',
  '#1f988b', '#1f998a', '#1f9a8a', '#1f9b89', '#1f9c89', '#209d89', '#209e88', '#209f88',
  '#20a088', '#20a187', '#20a187', '#20a287', '#20a386', '#21a486', '#21a585', '#22a685',
  '#22a784', '#23a884', '#24a983', '#25aa82', '#26ab82', '#27ac81', '#28ac81', '#29ad80',
  '#2aae7f', '#2aaf7f', '#2bb07e', '#2cb17e', '#2db27d', '#2eb37c', '#30b47c', '#31b57b',
  '#33b57a', '#34b679', '#36b778', '#38b877', '#39b976', '#3bba75', '#3cbb75', '#3ebb74',
  '#40bc73', '#41bd72', '#43be71', '#44bf70', '#46c06f', '#48c16e', '#4ac16d', '#4cc26c',
  '#4ec36b', '#50c469', '#52c468', '#54c567', '#56c666', '#58c765', '#5ac764', '#5dc862',
  '#5fc961', '#61ca60', '#63cb5f', '#65cb5e', '#67cc5c', '#6acd5b', '#6ccd59', '#6ece58',
  '#71cf56', '#73cf55', '#75d054', '#78d152', '#7ad151', '#7dd24f', '#7fd34e', '#81d34c',
  '#84d44b', '#86d449', '#89d548', '#8bd646', '#8ed645', '#90d743', '#93d741', '#96d83f',
  '#98d83e', '#9bd93c', '#9dd93a', '#a0da39', '#a3da37', '#a5db35', '#a8db34', '#aadc32',
  '#addc30', '#b0dd2f', '#b2dd2d', '#b5dd2c', '#b8de2a', '#bade29', '#bddf28', '#c0df26',
  '#c2df25', '#c5e023', '#c8e022', '#cae020', '#cde11f', '#d0e11e', '#d2e21c', '#d5e21b',
  '#d8e219', '#dae31a', '#dde31b', '#dfe31c', '#e2e41c', '#e4e41d', '#e7e41e', '#e9e51f',
  '#ece51f', '#eee520', '#f1e521', '#f3e622', '#f6e622', '#f8e623', '#fbe724', '#fde725',
];
