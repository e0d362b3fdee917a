var kt,nm,jx,Qs,rd,Ol,im,Dl,sm,ld,od,rm,va=Symbol.for("pv"),kl={},Bl=[],ey=/^m(i|n|o|s|text|space)$/,cd=Array.isArray,om=Bl.slice,Ar=Object.assign;function Tr(n){n&&n.parentNode&&n.remove()}function Nl(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:va,__v:s||++nm,__i:-1,__u:0};return!s&&kt.vnode&&kt.vnode(r),r}function xt(n){return n.children}function Fl(n,e){this.props=n,this.context=e,this.__g=0}function js(n,e){if(e==null)return n.__&&js(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:js(n)}function ty(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Ar({constructor:va},t)).__v=t.__v+1,kt.vnode&&kt.vnode(e),ud(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||js(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,dm(s,e,r),t.__=t.__e=null,e.__e!=i&&am(e))}function am(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),am(n)}function ad(n){(8&n.__g||(n.__g|=8,Qs.push(n),Ol++))&&rd==kt.debounceRendering||((rd=kt.debounceRendering)||queueMicrotask)(lm)}function lm(){try{for(var n,e=1;Qs.length;)Qs.length>e&&Qs.sort(im),n=Qs.shift(),e=Qs.length,8&n.__g&&ty(n)}finally{(Ol=Qs.length)&&(rd||queueMicrotask)(lm)}}function cm(n,e,t,i,s,r,o,a,l,c,u){var d,h,f,g,y,p,m=i.__k||Bl,x=e.length;for(l=ny(t,e,m,l,x),d=0;d<x;d++)(f=t.__k[d])!=null&&(h=~f.__i&&m[f.__i]||kl,f.__i=d,p=ud(n,f,h,s,r,o,a,l,c,u),g=f.__e,(h.ref!=f.ref||8&h.__u)&&(h.ref&&hd(h.ref,null,f,h),f.ref&&u.push(f.ref,f.__c||g,f)),y=y||g,4&f.__u?(l=um(f,l,n,!h.__v),h.__e&&(h.__e=null)):typeof f.type=="function"&&p!==void 0?l=p:g&&(l=g.nextSibling),f.__u&=-21);return t.__e=y,l}function ny(n,e,t,i,s){var r,o,a,l,c,u,d,h,f,g=t.length,y=g,p=0,m=0,x=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=x[r]=Nl(null,o):cd(o)?o=x[r]=Nl(xt,{children:o}):o.constructor===va&&o.__b?o=x[r]=Nl(o.type,o.props,o.key,o.ref,o.__v):x[r]=o,l=r+p,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=iy(o,t,l,y))&&(y--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?p--:c==l+1?p++:c!=l&&(c>l?p--:p++,m=1)):(~c||(s>g?p--:s<g&&p++),typeof o.type!="function"&&(o.__u|=4))):x[r]=null;if(m){for(u=[],d=[],r=0;r<s;r++)if((o=x[r])&&16&o.__u){for(p=0,h=u.length;p<h;)u[f=p+h>>1]<o.__i?p=f+1:h=f;u[p]=o.__i,d[r]=p+1}for(p=u.length;r--;)d[r]&&(d[r]==p?p--:x[r].__u|=4)}if(y)for(r=0;r<g;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=js(a)),dd(a,a));return i}function um(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=um(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=js(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function iy(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function tm(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Ll(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||tm(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||tm(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=od[e]||(od[e]=sy(e)),(n.__a||(n.__a={}))[e]=ld,r=e!=(e=e.replace(sm,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function sy(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[Dl]==null)e[Dl]=ld++;else if(e[Dl]<this.__a[n])return;return t(kt.event?kt.event(e):e)}}}function ud(n,e,t,i,s,r,o,a,l,c){var u,d,h,f,g,y,p,m,x,E,S,R,C,v,w,U,I,D,z=e.type;if(e.constructor!==va)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,d=r=[],u.nodeType==8?a=Ul(u,r):r.push(u),a=r[0]||a),(u=kt.__b)&&u(e);e:if(typeof z=="function"){h=o.length;try{if(m=e.props,x=(u=z.prototype)&&u.render,E=(u=z.contextType)&&i[u.__c],S=u?E?E.props.value:u.__:i,(f=t.__c)?(e.__c=f,2&f.__g&&(f.__g|=1)):(x?e.__c=f=new z(m,S):(e.__c=f=new Fl(m,S),f.constructor=z,f.render=oy),E&&E.sub(f),f.state||(f.state={}),f.__n=i,f.__g|=8,f.__h=[],f.__k=[]),x&&(f.__s||(f.__s=f.state),z.getDerivedStateFromProps&&(f.__s==f.state&&(f.__s=Ar({},f.__s)),Ar(f.__s,z.getDerivedStateFromProps(m,f.__s)))),g=f.props,y=f.state,f.__v=e,t.__c){if(m!==g&&x&&!z.getDerivedStateFromProps&&f.componentWillReceiveProps&&f.componentWillReceiveProps(m,S),e.__v==t.__v&&!(8&f.__g)||!(4&f.__g)&&f.shouldComponentUpdate&&f.shouldComponentUpdate(m,f.__s,S)===!1){e.__v!=t.__v&&(f.props=m,f.state=f.__s,f.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(G){G&&(G.__=e)}),Bl.push.apply(f.__h,f.__k),f.__k=[],f.__h.length&&o.push(f),a=js(t);break e}f.componentWillUpdate&&f.componentWillUpdate(m,f.__s,S),x&&f.componentDidUpdate&&f.__h.push(function(){f.componentDidUpdate(g,y,p)})}else x&&!z.getDerivedStateFromProps&&f.componentWillMount&&f.componentWillMount(),x&&f.componentDidMount&&f.__h.push(f.componentDidMount);f.context=S,f.props=m,f.__P=n,f.__g&=-5,R=kt.__r,C=x?25:0;do f.__g&=-9,R&&R(e),u=f.render(f.props,f.state=f.__s,f.context);while(8&f.__g&&++C<25);x&&(Bl.push.apply(f.__h,f.__k),f.__k=[]),f.state=f.__s,f.getChildContext&&(i=Ar({},i,f.getChildContext())),x&&t.__c&&f.getSnapshotBeforeUpdate&&(p=f.getSnapshotBeforeUpdate(g,y)),v=u&&u.type===xt&&u.key==null?u.props.children:u,m.__P&&(u=a,s=(n=m.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(G){G&&dd(G,G)}),t.__k=null),a=t.__k?js(t,0):null),a=cm(n,cd(v)?v:[v],e,t,i,s,r,o,a,l,c),m.__P&&(e.__e=null,a=u),e.__u&=-161,d&&d.some(Tr),f.__h.length&&o.push(f),1&f.__g&&(f.__g&=-4)}catch(G){if(o.length=h,e.__v=null,l||r)if(G&&G.then){if(e.__u|=128|l,r){for(~(I=r.indexOf(a||void 0))||(I=r.length);(D=r[I-1])&&D.nodeType==8;)I--;for(;I<r.length;I++)if(D=r[I])if(r[I]=null,w){if(D==U)break}else{if(D.nodeType!=8)break;D.data.startsWith("$s")&&(U=Ul(w=D))}}if(!w){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;w=a}(u=Ul(w=e.__c.__z||(e.__c.__z=w)))?(e.__e=w,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(Tr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),G&&G.then||hm(e),kt.__e(G,e,t)}}else a=e.__e=ry(t.__e,e,t,i,s,r,o,l,c,n);return(u=kt.diffed)&&u(e),a}function Ul(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function hm(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(hm))}function dm(n,e,t){for(var i=0;i<t.length;)hd(t[i++],t[i++],t[i++]);kt.__c&&kt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){kt.__e(r,s.__v)}})}function ry(n,e,t,i,s,r,o,a,l,c){var u,d,h,f,g,y,p,m,x=t.props||kl,E=e.props,S=e.type;if(S=="svg"?s="http://www.w3.org/2000/svg":S=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((g=r[u])&&(S?g.localName==S:g.nodeType==3)){n=g,r[u]=null;break}}if(!n){if(m=c.ownerDocument||document,!S)return m.createTextNode(E);n=m.createElementNS(s,S,E.is?E:c),a&&(kt.__m&&kt.__m(e,r),a=!1),r=null}if(S){if(c=S=="template"&&n.content||n,r=S=="textarea"&&E.defaultValue!=null?null:r&&om.call(c.childNodes),!a&&r)for(x={},u=0;u<n.attributes.length;u++)x[(g=n.attributes[u]).name]=g.value;for(u in x)g=x[u],u=="dangerouslySetInnerHTML"?h=g:u=="children"||u in E||u=="value"&&"defaultValue"in E||u=="checked"&&"defaultChecked"in E||Ll(n,u,null,g,s);for(u in E)g=E[u],u=="children"?f=g:u=="dangerouslySetInnerHTML"?d=g:u=="value"?y=g:u=="checked"?p=g:a&&typeof g!="function"||x[u]===g||Ll(n,u,g,x[u],s);d?(a||h&&(d.__html==h.__html||d.__html==n.innerHTML)||(n.innerHTML=d.__html),e.__k=[]):(h&&(n.textContent=""),(S=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&ey.test(S))&&(s="http://www.w3.org/1999/xhtml"),cm(c,cd(f)?f:[f],e,t,i,s,r,o,r?r[0]:t.__k&&js(t,0),a,l),r&&r.some(Tr)),a&&S!="textarea"||(u="value",S=="progress"&&y==null?n.removeAttribute(u):y==null||y===n[u]&&(S!="progress"||y)||Ll(n,u,y,x[u],s),u="checked",p!=null&&p!=n[u]&&Ll(n,u,p,x[u],s))}else x===E||a&&n.data==E||(n.data=E);return n}function hd(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){kt.__e(s,t)}}function dd(n,e,t){var i,s,r,o;if(kt.unmount&&kt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||hd(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){kt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&dd(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=Ul(i,r=[]))&&(i==n.__e&&r.some(Tr),Tr(s),Tr(i)),t||Tr(n.__e),n.__e=n.__c=n.__=null}function oy(n,e,t){return this.constructor(n,t)}function zl(n,e){var t,i,s,r;kt.__&&kt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Nl(xt,{children:[n]}),s=[],r=[],ud(e,e.__k,i||kl,kl,e.namespaceURI,i?null:e.firstChild?om.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),dm(s,e.__k,r),e.__k.props.children=null}function fm(n){function e(t){var i,s;return this.getChildContext||(i=new Set,(s={})[e.__c]=this,this.getChildContext=function(){return s},this.shouldComponentUpdate=function(r){this.props.value!=r.value&&i.forEach(function(o){o.__g|=4,ad(o)})},this.sub=function(r){i.add(r);var o=r.componentWillUnmount;r.componentWillUnmount=function(){i.delete(r),o&&o.call(r)}}),t.children}return e.__c="__cC"+rm++,e.__=n,e.Provider=(e.Consumer=function(t,i){return t.children(i)}).contextType=e,e}kt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw Ol=0,n}},nm=0,jx=function(n){return n!=null&&n.constructor===va},Fl.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Ar({},this.state)),typeof n=="function"&&(n=n(Ar({},t),this.props)),n&&(Ar(t,n),this.__v&&(e&&this.__k.push(e),ad(this)))},Fl.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),ad(this))},Fl.prototype.render=xt,Qs=[],Ol=0,im=function(n,e){return n.__v.__b-e.__v.__b},Dl=Symbol(),sm=/(PointerCapture)$|Capture$/i,ld=0,od={},rm=0;var bm=[{map:"viridis",title:"Viridis"},{map:"cividis",title:"Cividis"},{map:"turbo",title:"Turbo (not colour-blind safe)"},{map:"grey",title:"Grey"}],ay={viridis:"440154470d6048186a482374472d7b4537814240863e49893b528b375b8d33638d2f6b8e2c728e297a8e26828e23898e21918c1f988b1fa08822a78528ae8032b67a3fbc734ec36b5ec96270cf5784d44b98d83eaddc30c2df23d8e219ece51bfde725",cividis:"00224e00285b002e6a0533711a386f273e6e32436d3b496c434e6c4b546c535a6d5a5f6e61656f686a716f70737676767d7c788482798c8878938e789b9476a39a74aba072b4a76fbcae6cc4b468cdbb63d5c25edec958e7d150f0d846f9e03afee838",turbo:"30123b392a734040a24456c7466be34680f64294ff37a8fa28bceb1ccdd818ddc21fe9af32f2984ef97d6dfe628bff4ba4fc3cb9f635cdec34dfdf37eecf3af8be39fdac34fe962bfb7e21f46617eb500edf3f08d02f05be2102a91601920b017a0403",grey:"0a0a0affffff"},ly="08306b2171b56baed6c6dbeff2f0ecfdd0a2f1914ecc4c02702a04",us=256;function Vl(n){return(n.match(/.{6}/g)??[]).map(e=>{let t=Number.parseInt(e,16);return[t>>16,t>>8&255,t&255]})}function cy(n){let e=new Uint8Array(us*4);for(let t=0;t<us;t++){let i=t/(us-1)*(n.length-1),s=Math.min(Math.floor(i),n.length-2),[r,o]=[n[s],n[s+1]],a=l=>r[l]+(o[l]-r[l])*(i-s);e.set([a(0),a(1),a(2),255],t*4)}return e}var pm=new Map;function Sm(n){let e=pm.get(n)??cy(Vl(n));return pm.set(n,e),e}function fo(n){return Sm(ay[n])}function po(){return Sm(ly)}var mm=32,gm=7,_m=Vl("3a40480b0d10e69f0056b4e9f0e4420072b2d55e00ffffffcc79a7999999009e73882255aa4499ddcc7711773388ccee332288cc667744aa99b0724a7f7fffc8e6a0");function er(n){let e=_m.length-gm,t=n<mm?n%e:e+(n-mm)%gm;return _m[t]}function Gl(){let n=new Uint8Array(us*4);for(let e=0;e<us;e++)n.set([...er(e),255],e*4);return n}var vm=127,xm=Vl("7a5195b9a44c4a5f8a7f858db9c0c9"),uy=[47,163,107];function xa(n){return n===0?uy:n<vm?er(n):xm[(n-vm)%xm.length]}function on([n,e,t]){return`rgb(${n}, ${e}, ${t})`}var ym=Vl("2f7fd0c47f001d8f66c04f00b0578c7a5fe0");function Qn(n){return ym[n%ym.length]}var Mm=`#version 300 es
out vec2 place;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  place = vec2(corner.x, 1.0 - corner.y);
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}`,wm=`#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
in vec2 place;
out vec4 color;
uniform int mode;
uniform usampler2D measured;
uniform usampler2D truth;
uniform sampler2D picture;
uniform sampler2D table;
uniform vec2 range;
uniform bool isRelative;
uniform vec3 empty[2];

vec3 lookUp(float from0to1) {
  return texture(table, vec2((clamp(from0to1, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

// Pixels without a value get a hatch, which no colour map has.
vec3 hatch() {
  return empty[int(mod(gl_FragCoord.x + gl_FragCoord.y, 8.0) < 2.0)];
}

uint at(usampler2D image) {
  ivec2 size = textureSize(image, 0);
  return texelFetch(image, min(ivec2(place * vec2(size)), size - 1), 0).r;
}

void main() {
  color.a = 1.0;
  if (mode == 0) {
    color.rgb = texture(picture, place).rgb;
    return;
  }
  uint value = at(measured);
  if (mode == 1) {
    float metres = float(value) * 0.001;
    color.rgb = value == 0u ? hatch() : lookUp((metres - range.x) / max(range.y - range.x, 1e-6));
  } else if (mode == 2) {
    uint exact = at(truth);
    float error = (float(value) - float(exact)) * 0.001;
    if (isRelative) error *= 100.0 / max(float(exact) * 0.001, 1e-3);
    color.rgb = value == 0u || exact == 0u ? hatch() : lookUp(0.5 + 0.5 * error / max(range.y, 1e-9));
  } else if (mode == 3) {
    color.rgb = vec3(float(value) / 255.0);
  } else if (mode == 4) {
    color.rgb = texelFetch(table, ivec2(int(value), 0), 0).rgb;
  } else {
    color.rgb = lookUp(float(value) / 255.0);
  }
}`,wi={picture:0,depth:1,error:2,grey:3,code:4,scale:5};var Rs={measured:0,truth:1,picture:2,table:3},Hl=class{canvas=new OffscreenCanvas(1,1);gl;uniforms;slots=new Map;tables=new Map;reasons=Gl();blank;constructor(e){let t={antialias:!1,alpha:!1,depth:!1,preserveDrawingBuffer:!1},i=this.canvas.getContext("webgl2",t);if(!i)throw new Error("WebGL 2 is not available.");this.gl=i,this.canvas.addEventListener("webglcontextlost",s=>s.preventDefault()),this.canvas.addEventListener("webglcontextrestored",()=>{this.slots.clear(),this.tables.clear(),this.uniforms=this.link(),this.blank=this.integerTexture(),e()}),this.uniforms=this.link(),this.blank=this.integerTexture()}paint(e,t){let i=e.getContext("bitmaprenderer",{alpha:!1});if(!i||!this.bind(t))return!1;let{width:s,height:r}=e;return this.canvas.width!==s&&(this.canvas.width=s),this.canvas.height!==r&&(this.canvas.height=r),this.gl.viewport(0,0,s,r),this.gl.drawArrays(this.gl.TRIANGLES,0,3),i.transferFromImageBitmap(this.canvas.transferToImageBitmap()),!0}keep(e){for(let[t,i]of this.slots)e.some(s=>t.startsWith(`${s}/`))||(this.gl.deleteTexture(i.texture),this.slots.delete(t))}bind(e){let{gl:t,uniforms:i}=this,{kind:s,frame:r,display:o,scales:a}=e,l=r.pictures.get("reference")??r.pictures.get("depth"),c=s==="error"?r.pictures.get("sensor"):s==="depth"?l:r.pictures.get(s);if(!c||s==="error"&&!l)return!1;let u=s==="depth"||s==="sensor"?wi.depth:s==="error"?wi.error:s==="reason"?wi.code:s==="confidence"?wi.scale:s==="color"?wi.picture:wi.grey,[d,h]=s==="error"?[0,a.error]:a.depth;t.uniform1i(i.mode,u),t.uniform2f(i.range,d,h),t.uniform1i(i.isRelative,+(o.errorUnit==="%")),t.uniform3fv(i.empty,e.empty),this.upload(u===wi.picture?Rs.picture:Rs.measured,e.oak,c),this.use(Rs.truth,this.blank),u===wi.error&&l&&this.upload(Rs.truth,e.oak,l),u===wi.picture&&this.use(Rs.measured,this.blank);let f=u===wi.error?po():u===wi.code?this.reasons:fo(o.depthMap);return this.useTable(Rs.table,f),u!==wi.picture&&this.useTable(Rs.picture,f),!0}use(e,t){this.gl.activeTexture(this.gl.TEXTURE0+e),this.gl.bindTexture(this.gl.TEXTURE_2D,t)}upload(e,t,i){let{gl:s}=this,r=`${t}/${i.name}`,o=`${i.width}×${i.height}`,a=this.slots.get(r);if(a||(a={texture:this.integerTexture(),picture:null,size:""},this.slots.set(r,a)),this.use(e,a.texture),a.picture===i)return;let[l,c,u]=i.format==="rgba8"?[s.RGBA8,s.RGBA,s.UNSIGNED_BYTE]:i.format==="u16mm"?[s.R16UI,s.RED_INTEGER,s.UNSIGNED_SHORT]:[s.R8UI,s.RED_INTEGER,s.UNSIGNED_BYTE];a.size===o?s.texSubImage2D(s.TEXTURE_2D,0,0,0,i.width,i.height,c,u,i.data):s.texImage2D(s.TEXTURE_2D,0,l,i.width,i.height,0,c,u,i.data),i.format==="rgba8"&&(s.texParameteri(s.TEXTURE_2D,s.TEXTURE_MIN_FILTER,s.LINEAR),s.texParameteri(s.TEXTURE_2D,s.TEXTURE_MAG_FILTER,s.LINEAR)),a.size=o,a.picture=i}useTable(e,t){let{gl:i}=this,s=this.tables.get(t);if(s)return this.use(e,s);let r=this.texture();this.use(e,r),i.texImage2D(i.TEXTURE_2D,0,i.RGBA8,us,1,0,i.RGBA,i.UNSIGNED_BYTE,t),this.filter(i.NEAREST),this.tables.set(t,r)}texture(){let e=this.gl.createTexture();if(!e)throw new Error("The graphics driver has no more textures.");return e}integerTexture(){let{gl:e}=this,t=this.texture();return this.use(Rs.measured,t),e.texImage2D(e.TEXTURE_2D,0,e.R8UI,1,1,0,e.RED_INTEGER,e.UNSIGNED_BYTE,new Uint8Array(1)),this.filter(e.NEAREST),t}filter(e){let{gl:t}=this;t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MIN_FILTER,e),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MAG_FILTER,e),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_S,t.CLAMP_TO_EDGE),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_T,t.CLAMP_TO_EDGE)}link(){let{gl:e}=this,t=e.createProgram();for(let[s,r]of[[e.VERTEX_SHADER,Mm],[e.FRAGMENT_SHADER,wm]]){let o=e.createShader(s);o&&(e.shaderSource(o,r),e.compileShader(o),e.attachShader(t,o))}if(e.linkProgram(t),!e.getProgramParameter(t,e.LINK_STATUS)&&!e.isContextLost())throw new Error(e.getProgramInfoLog(t)??"The shaders do not link.");e.useProgram(t),e.pixelStorei(e.UNPACK_ALIGNMENT,1);let i=s=>e.getUniformLocation(t,s);for(let[s,r]of Object.entries(Rs))e.uniform1i(i(s),r);return{mode:i("mode"),measured:i("measured"),truth:i("truth"),picture:i("picture"),table:i("table"),range:i("range"),isRelative:i("isRelative"),empty:i("empty")}}};var ya=class extends Error{},Em=24;function Tm(n,e){let t=new Uint8Array(e),i=0,s=0,r=o=>{let a=o===15?255:0;for(;a===255;)a=n[i++]??0,o+=a;return o};for(;i<n.length;){let o=n[i++],a=r(o>>4);if(i+a>n.length||s+a>e)throw new ya("The literals exceed the block.");if(a<Em)for(let u=0;u<a;u++)t[s+u]=n[i+u];else t.set(n.subarray(i,i+a),s);if(i+=a,s+=a,i>=n.length)break;let l=n[i]|(n[i+1]??0)<<8;i+=2;let c=r(o&15)+4;if(l===0||l>s||s+c>e)throw new ya("A copy exceeds the output.");hy(t,s,l,c),s+=c}if(s!==e)throw new ya(`The block has ${s} bytes instead of ${e}.`);return t}function hy(n,e,t,i){if(i<Em){for(let r=0;r<i;r++)n[e+r]=n[e+r-t];return}let s=Math.min(t,i);for(n.copyWithin(e,e-t,e-t+s);s<i;){let r=Math.min(s,i-s);n.copyWithin(e+s,e,e+r),s+=r}}var dy={rgba8:4,u16mm:2,u8:1};function Am(n){let e=new DataView(n).getUint32(0,!0),t=new TextDecoder().decode(new Uint8Array(n,4,e));return[JSON.parse(t),4+e]}function Cm(n,e){let[t,i]=Am(n),s=new Map;for(let r of t.images){let{name:o,width:a,height:l,format:c}=r;if(r.unchanged){let f=e(t.oak)?.get(o);f&&s.set(o,f);continue}let u=new Uint8Array(n,i+r.offset,r.length),d=Tm(u,a*l*dy[c]),h=c==="u16mm"?new Uint16Array(d.buffer):d;s.set(o,{name:o,width:a,height:l,format:c,data:h})}return{header:t,pictures:s}}function Wl(n){let[e,t]=Am(n),{vertices:i,triangles:s}=e,r=Math.ceil(t/4)*4,o=a=>{let l=r;return r+=a,l};return{header:e,positions:new Float32Array(n,o(i*12),i*3),colors:new Uint8Array(n,o(i*4),i*4),indices:new Uint32Array(n,o(s*12),s*3),objects:new Uint32Array(n,o(s*4),s)}}var go=class extends Error{constructor(t,i){super(t.error);this.failure=t;this.status=i}failure;status;get findings(){return this.failure.findings??[]}};async function ba(n,e){let t=await fetch(n,e);if(t.ok)return t;let i=await t.text();throw new go(fy(i,t),t.status)}function fy(n,e){try{let t=JSON.parse(n);if(typeof t.error=="string")return t}catch{}return{error:n.trim()||`The server answered ${e.status} ${e.statusText}.`}}async function mo(n,e){return await(await ba(n,e)).json()}function Xl(n,e){let t={method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(n)};return e&&(t.signal=e),t}var hn={catalog:()=>mo("/api/catalog"),scene:n=>mo(`/api/scenes/${encodeURIComponent(n)}`),async sceneMesh(n,e){let t=await ba(`/api/scenes/${encodeURIComponent(n)}/mesh?triangles=${e}`);return Wl(await t.arrayBuffer())},async body(n){let e=await ba(`/api/models/${encodeURIComponent(n)}/body`);return Wl(await e.arrayBuffer())},openScene:n=>mo(`/api/scenes?name=${encodeURIComponent(n.name)}`,{method:"POST",body:n}),openCalibration:n=>mo(`/api/calibrations?name=${encodeURIComponent(n.name)}`,{method:"POST",body:n}),accuracy:(n,e)=>mo("/api/accuracy",Xl(n,e)),coverage:(n,e)=>mo("/api/coverage",Xl(n,e)),async surface(n,e){let t=await ba("/api/coverage/surface",Xl(n,e));return Wl(await t.arrayBuffer())},async export(n){let e=await ba("/api/export",Xl(n)),t=e.headers.get("Content-Disposition")??"",i=/filename="([^"]+)"/.exec(t)?.[1]??`oaktwin-${n.what}`,s=JSON.parse(e.headers.get("X-Findings")??"[]");return{name:i,file:await e.blob(),findings:s}}};var Cr,_n,fd,Rm,pd=Object.is,ql=0,km=[],md=[],Sn=kt,Pm=Sn.__b,Im=Sn.__r,Lm=Sn.diffed,Dm=Sn.__c,Nm=Sn.unmount,Fm=Sn.__;function Ma(n,e){Sn.__h&&Sn.__h(_n,n,ql||e),ql=0;var t=_n.__H||(_n.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Pt(n){return ql=1,py(zm,n)}function py(n,e,t){var i=Ma(Cr++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):zm(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);pd(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=_n,!_n.__f)){_n.__f=!0;var s=_n.shouldComponentUpdate;_n.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(h){h.__N&&(c=!0,pd(h.__[0],h.__N[0])||(u=!0))}),s){var d=s.call(this,r,o,a);return c?d||u:d}return!c||u}}return i.__}function Ht(n,e){var t=Ma(Cr++,3);!Sn.__s&&_d(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,_n.__H.__h.push(t))}function hs(n,e){var t=Ma(Cr++,4);!Sn.__s&&_d(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,_n.__h.push(t))}function Tt(n){return ql=5,Rr(function(){return{current:n}},[])}function Rr(n,e){var t=Ma(Cr++,7);return _d(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function Bm(n){var e=_n.context[n.__c],t=Ma(Cr++,9);return t.c=n,e?(t.__==null&&(t.__=!0,e.sub(_n)),e.props.value):n.__}function my(){var n;do{for(;n=md.shift();)try{Sa(n)}catch(t){Sn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=km.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Sa),e.__h.some(gd),e.__h=[]}catch(t){e.__h=[],Sn.__e(t,n.__v)}}}while(md.length)}Sn.__b=function(n){_n=null,Pm&&Pm(n)},Sn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Fm&&Fm(n,e)},Sn.__r=function(n){Im&&Im(n),Cr=0;var e=(_n=n.__c).__H;e&&(fd==_n?_n.__h=[]:(e.__h.some(Sa),e.__h.some(gd),Cr=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),fd=_n},Sn.diffed=function(n){Lm&&Lm(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&Om(km.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),fd=_n=null},Sn.__c=function(n,e){e.some(function(t){try{t.__h.some(Sa),t.__h=t.__h.filter(function(i){return!i.__||gd(i)})}catch(i){t.__h=[function(){throw i}]}}),Dm&&Dm(n,e)},Sn.unmount=function(n){Nm&&Nm(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,Om(md.push(s))}else Sa(s)}catch(r){e=r}}),i.__H=void 0,e&&Sn.__e(e,i.__v))};var Um=typeof requestAnimationFrame=="function";function gy(n){var e,t=function(){clearTimeout(i),Um&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Um&&(e=requestAnimationFrame(t))}function Om(n){n!=1&&Rm==Sn.requestAnimationFrame||((Rm=Sn.requestAnimationFrame)||gy)(my)}function Sa(n){var e=_n,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),_n=e}function gd(n){var e=_n;n.__c=n.__(),_n=e}function _d(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!pd(t,n[i])})}function zm(n,e){return typeof e=="function"?e(n):e}var Bt=class{constructor(e){this.value=e}value;listeners=new Set;get(){return this.value}set(e){if(!Object.is(e,this.value)){this.value=e;for(let t of[...this.listeners])t()}}update(e){this.set(e(this.value))}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}};function Ae(n){let[e,t]=Pt(()=>n.get());return Ht(()=>{let i=()=>t(()=>n.get());return i(),n.subscribe(i)},[n]),e}function Ps(n,e){let[,t]=Pt(0),i=e(n.get());return Ht(()=>{let s=i,r=()=>{let o=e(n.get());Object.is(o,s)||(s=o,t(a=>a+1))};return r(),n.subscribe(r)}),i}function vd({model:n,calibration:e,populationSeed:t,sensor:i,lens:s,engine:r,preset:o,extendedDisparity:a,drift:l}){return JSON.stringify([n,e,t,i,s,r,o,a,l])}var Yl=class extends Bt{constructor(){super(new Map)}learn(e,t){let i=this.get().get(vd(e))??{},s=Object.entries(t).filter(([r,o])=>!(r in e.parameters)&&i[r]!==o);s.length&&this.set(new Map(this.get()).set(vd(e),{...i,...Object.fromEntries(s)}))}of(e,t){return this.get().get(vd(e))?.[t.name]??t.default}};var Vm=[200,500,1e3,2e3],$l=class{constructor(e){this.handlers=e}handlers;socket=null;attempts=0;pictures=new Map;connect(){let e=location.protocol==="https:"?"wss:":"ws:",t=new WebSocket(`${e}//${location.host}/api/live`);t.binaryType="arraybuffer",t.onopen=()=>{this.socket=t,this.attempts=0,this.pictures.clear(),this.handlers.onConnection("open")},t.onmessage=({data:i})=>{typeof i=="string"?this.handlers.onMessage(JSON.parse(i)):this.handlers.onFrame(this.decode(i))},t.onclose=()=>{this.socket=null,this.handlers.onConnection("lost");let i=Vm[Math.min(this.attempts++,Vm.length-1)];setTimeout(()=>this.connect(),i)}}decode(e){let t=Cm(e,s=>this.pictures.get(s)),{oak:i}=t.header;return this.pictures.set(i,new Map([...this.pictures.get(i)??[],...t.pictures])),t}send(e){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(JSON.stringify(e)),!0)}};var Zl=class{constructor(e){this.send=e}send;waiting=new Map;sent=new Map;lastId=0;request(e){this.waiting.set(e.oak,e),this.flush(e.oak)}settle(e,t){let i=this.sent.get(e),s=i?.get(t)??null;for(let r of[...i?.keys()??[]])r<=t&&i?.delete(r);return this.flush(e),s}forget(e){this.waiting.delete(e),this.sent.delete(e)}reset(){this.waiting.clear(),this.sent.clear()}get isIdle(){return this.waiting.size===0&&[...this.sent.values()].every(e=>e.size===0)}flush(e){let t=this.waiting.get(e),i=this.sent.get(e)??new Map;if(!t||i.size>=2)return;let s=++this.lastId;this.send({type:"frame",id:s,...t})&&(this.waiting.delete(e),i.set(s,t),this.sent.set(e,i))}};var Ui=[{kind:"color",title:"Colour",help:"The colour image in the view of the depth sensor",images:["color"]},{kind:"depth",title:"Exact depth",help:"The true distance along the optical axis",images:["depth","reference"]},{kind:"sensor",title:"Sensor depth",help:"The depth that the OAK measures",images:["sensor"]},{kind:"error",title:"Error",help:"Measured minus true depth",images:["sensor","depth","reference"]},{kind:"confidence",title:"Confidence",help:"How sure the matcher is of each pixel; not made by every engine",images:["confidence"]},{kind:"left",title:"Left",help:"The rectified infrared image of the left camera",images:["left"]},{kind:"right",title:"Right",help:"The rectified infrared image of the right camera",images:["right"]},{kind:"reason",title:"Reasons",help:"Why a pixel has no value",images:["reason"]}],vo=[{size:"small",title:"640 × 400",limit:[640,400]},{size:"large",title:"1280 × 800",limit:[1280,800]},{size:"native",title:"Native",limit:null}],_o={theme:"auto",panels:["color","depth","sensor","error"],wipe:null,wipeAt:.5,depthMap:"viridis",depthRange:null,errorRange:null,errorUnit:"mm",fullSize:"large",showCameras:!0,showRanges:!0,showGrid:!0,showScene:!0,showRoof:!1,cloud:"none",cloudColor:"error",paintsCoverage:!0,split:.46,showLeft:!0,showRight:!0},Gm="oaktwin-studio-display";function Hm(){try{return xd(JSON.parse(localStorage.getItem(Gm)??"{}"))}catch{return _o}}function Wm(n){try{localStorage.setItem(Gm,JSON.stringify(n))}catch{}}function xd(n){let e={..._o};if(typeof n!="object"||n===null)return e;for(let[t,i]of Object.entries(n))vy(t,i)&&Object.assign(e,{[t]:i});return e}var _y={theme:["auto","light","dark"],depthMap:["viridis","cividis","turbo","grey"],errorUnit:["mm","%"],fullSize:["small","large","native"],cloud:["none","truth","measurement","both"],cloudColor:["depth","error","reason","oak"]};function vy(n,e){let t=i=>Ui.some(s=>s.kind===i);switch(n){case"panels":return Array.isArray(e)&&e.every(t);case"wipe":return e===null||t(e?.left)&&t(e?.right);case"depthRange":return e===null||Array.isArray(e)&&e.length===2&&e.every(Number.isFinite);case"errorRange":return e===null||Number.isFinite(e)&&e>0;case"wipeAt":case"split":return Number.isFinite(e)&&e>=0&&e<=1;default:return _y[n]?.includes(e)??(n in _o&&typeof e==typeof _o[n])}}function Xm(n){let e=new Map;for(let i of n)for(let s=i.lastIndexOf("/");s>0;s=i.lastIndexOf("/",s-1)){let r=i.slice(0,s);e.set(r,(e.get(r)??0)+1)}let t=[...e].filter(([,i])=>i>1).map(([i])=>i);return[...new Set([...n,...t])].sort()}var tr=[0,0,1,1],wa=6;function gi(n,e){return n.models.find(t=>t.name===e)}function _i(n,e){return gi(n,e.model)?.depthSensors.find(t=>t.id===e.sensor)}function yd(n,e){return n.engines.find(t=>t.name===e.engine)}function Kl(n,e){let t=n.depthSensors[0];return{model:n.name,calibration:null,pose:e,sensor:t?.id??"",lens:"pinhole",engine:t?.engines[0]??"",preset:null,filters:null,parameters:{},extendedDisparity:!1,seed:0,deviceSeed:null,populationSeed:null,drift:{},projector:n.hasProjector?1:0,ambient:1}}function Jl(n,e){let{pose:t,seed:i,deviceSeed:s,populationSeed:r,ambient:o}=n,a={...Kl(e,t),seed:i,deviceSeed:s,populationSeed:r,ambient:o},l=e.depthSensors.find(({id:f})=>f===n.sensor);if(!l)return a;let c=l.kind==="stereo"?n.drift:{},u=l.engines.includes(n.engine)?n.engine:a.engine,d=n.preset!==null&&l.presets.includes(n.preset)?n.preset:null,h=u===n.engine?n.parameters:{};return{...a,sensor:l.id,engine:u,preset:d,parameters:h,drift:c,filters:n.filters,extendedDisparity:n.extendedDisparity}}function xy(n){let e=1;for(;n.some(t=>t.key===`oak${e}`);)e++;return`oak${e}`}function qm(n,e,t){let i=gi(n,n.model)??n.models[0],s=i?[{key:"oak1",isHidden:!1,state:Kl(i,t)}]:[];return{scene:e,oaks:s,selected:"oak1",arePosesLinked:!0,region:tr,target:null}}function Fn(n){return n.oaks.find(e=>e.key===n.selected)}function nr(n,e,t){let i=n.oaks.find(o=>o.key===e);if(!i)return n;let s=t(i.state),r=n.oaks.map(o=>o.key===e?{...o,state:s}:n.arePosesLinked&&s.pose!==i.state.pose?{...o,state:{...o.state,pose:s.pose}}:o);return{...n,oaks:r}}function bd(n,e){if(n.oaks.length>=wa)return n;let t={key:xy(n.oaks),isHidden:!1,state:e},i=n.oaks.findIndex(({key:s})=>s===n.selected)+1;return{...n,oaks:n.oaks.toSpliced(i,0,t),selected:t.key}}function Ym(n,e){if(n.oaks.length<=1)return n;let t=n.oaks.findIndex(r=>r.key===e),i=n.oaks.filter(r=>r.key!==e),s=i[Math.min(t,i.length-1)];return{...n,oaks:i,selected:n.selected===e?s?.key??"":n.selected}}var yy=150,$m=[[640,400],[480,300],[320,200],[240,150]],by=3,Sy=50,My=20;function Sd([n,e],t){let i=t?Math.min(t[0]/n,t[1]/e):1;return i>=1?null:[Math.round(n*i),Math.round(e*i)]}function Zm(n){let{wipe:e,cloud:t,cloudColor:i}=n,s=e?[e.left,e.right]:n.panels,r=new Set(["depth","reference","sensor"]);for(let o of Ui)if(s.includes(o.kind))for(let a of o.images)r.add(a);return t!=="none"&&i==="reason"&&r.add("reason"),[...r].sort()}var Ql=class{constructor(e,t,i){this.studio=e;this.probes=t;this.defaults=i;this.live=new $l({onConnection:s=>this.connected(s==="open"),onFrame:s=>this.show(s),onMessage:s=>this.read(s)}),this.scheduler=new Zl(s=>this.live.send(s)),t.connect(s=>this.live.send(s)),e.document.subscribe(()=>this.follow()),e.display.subscribe(()=>this.follow()),e.scene.subscribe(()=>this.follow()),this.live.connect()}studio;probes;defaults;received=0;live;scheduler;requested=new Map;moving=new WeakSet;coarseness=0;limits=new Map;timer=0;wasLost=!1;get isIdle(){return this.timer===0&&this.scheduler.isIdle&&this.probes.isIdle}connected(e){let{studio:t}=this;if(t.connection.set(e?"open":"lost"),this.scheduler.reset(),this.probes.reset(),this.requested.clear(),!e){this.wasLost=!0;return}this.wasLost&&t.restart().then(()=>t.notify("note","Connected to the server again."),i=>t.report("Reconnecting",i)),this.wasLost=!1,this.follow()}follow(){let{document:e,scene:t,connection:i}=this.studio,{oaks:s,region:r,scene:o}=e.get();if(i.get()!=="open"||t.get()?.id!==o)return;this.forgetRemoved(s);let{fullSize:a}=this.studio.display.get(),l=Zm(this.studio.display.get());for(let c of s){if(c.isHidden||!this.studio.hasDepth(c.state))continue;let u=[o,c.state,...r,a,...l],d=this.requested.get(c.key);if(d&&d.length===u.length&&d.every((g,y)=>g===u[y]))continue;this.requested.set(c.key,u);let h=d?.[1]?.pose!==c.state.pose,f=this.request(c,$m[h?this.coarseness:0]??null,l,h?by:1);h&&this.moving.add(f),this.rest()}}rest(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>{this.timer=0;let{document:e,display:t}=this.studio,i=vo.find(({size:r})=>r===t.get().fullSize)?.limit??null,s=Zm(t.get());for(let r of e.get().oaks)!r.isHidden&&this.studio.hasDepth(r.state)&&this.limits.get(r.key)!==Km(i,1)&&this.request(r,i,s,1)},yy)}request(e,t,i,s){let{scene:r,region:o}=this.studio.document.get(),a=_i(this.studio.catalog.get(),e.state)?.resolution,l=a?Sd(a,t):null;this.limits.set(e.key,Km(t,s));let c={oak:e.key,scene:r,state:e.state,size:l,images:i,region:o,colorStep:s};return this.scheduler.request(c),c}forgetRemoved(e){let t=s=>e.some(r=>r.key===s&&!r.isHidden),{frames:i}=this.studio;for(let s of this.requested.keys())t(s)||(this.requested.delete(s),this.scheduler.forget(s));[...i.get().keys()].some(s=>!t(s))&&i.set(new Map([...i.get()].filter(([s])=>t(s))))}show(e){let{id:t,oak:i}=e.header,s=this.scheduler.settle(i,t);s&&(this.received++,this.moving.has(s)&&this.adapt(e.header.milliseconds),this.defaults.learn(s.state,e.header.parameters),this.accept(i,s,e),this.probes.refresh(i))}adapt(e){e>Sy?this.coarseness=Math.min(this.coarseness+1,$m.length-1):e<My&&(this.coarseness=Math.max(this.coarseness-1,0))}accept(e,t,i){let{frames:s,rejections:r}=this.studio;r.get().has(e)&&r.set(wy(r.get(),e)),s.set(new Map(s.get()).set(e,{...i,state:t.state,scene:t.scene,requested:t.images}))}read(e){e.type==="probe"?this.probes.show(e):this.reject(e)}reject(e){this.probes.reject(e.id,e.oak)||this.scheduler.settle(e.oak,e.id)&&this.studio.rejections.set(new Map(this.studio.rejections.get()).set(e.oak,e))}};function Km(n,e){return`${n?.join()??"native"}/${e}`}function wy(n,e){return new Map([...n].filter(([t])=>t!==e))}var jl=class{constructor(e){this.studio=e;e.hover.subscribe(()=>this.follow())}studio;send=()=>!1;inFlight=null;waiting=null;lastId=1e9;connect(e){this.send=e}get isIdle(){return this.inFlight===null&&this.waiting===null}reset(){this.inFlight=null,this.waiting=null}refresh(e){this.studio.hover.get()?.oak===e&&this.follow()}show(e){e.id===this.inFlight?.id&&(this.inFlight=null,this.studio.hover.get()?.oak===e.oak&&this.studio.probe.set(e),this.flush())}reject(e,t){return e!==this.inFlight?.id||t!==this.inFlight.oak?!1:(this.inFlight=null,this.studio.probe.set(null),this.flush(),!0)}follow(){let e=this.studio.hover.get();if(!e){this.waiting=null,this.studio.probe.set(null);return}this.waiting={oak:e.oak,x:e.x,y:e.y},this.flush()}flush(){if(this.inFlight||!this.waiting)return;let e={type:"probe",id:++this.lastId,...this.waiting};this.send(e)&&(this.waiting=null,this.inFlight=e)}};var Ey=1e3,Ty=200,ec=class extends Bt{past=[];future=[];lastTag="";lastTime=0;commit(e,t){let i=this.get(),s=t(i);if(Object.is(i,s))return;let r=performance.now();e===this.lastTag&&r-this.lastTime<Ey||(this.past.push(i),this.past.length>Ty&&this.past.shift()),this.lastTag=e,this.lastTime=r,this.future=[],this.set(s)}reset(e){this.past=[],this.future=[],this.lastTag="",this.set(e)}undo(){this.step(this.past,this.future)}redo(){this.step(this.future,this.past)}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}step(e,t){let i=e.pop();i!==void 0&&(t.push(this.get()),this.lastTag="",this.set(i))}};var Jm=["theme","split","showLeft","showRight","wipeAt"],Md="v1.";function Qm({document:n,display:e}){let t=Object.entries(e).filter(([r,o])=>!Jm.includes(r)&&o!==_o[r]),i=JSON.stringify({document:n,display:Object.fromEntries(t)}),s=String.fromCharCode(...new TextEncoder().encode(i));return`#${Md}${btoa(s).replaceAll("+","-").replaceAll("/","_").replaceAll("=","")}`}function wd(n,e){let t=n.replace(/^#/,"");if(!t.startsWith(Md))return null;try{let i=atob(t.slice(Md.length).replaceAll("-","+").replaceAll("_","/")),s=new TextDecoder().decode(Uint8Array.from(i,l=>l.charCodeAt(0))),r=JSON.parse(s),o=Ay(r.document);if(!o)return null;let a=xd(r.display);for(let l of Jm)Object.assign(a,{[l]:e[l]});return{document:o,display:a}}catch{return null}}function xo(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)}function Ea(n,e){return Array.isArray(n)&&n.length===e&&n.every(Number.isFinite)?n:null}function Ay(n){if(!xo(n)||typeof n.scene!="string"||!Array.isArray(n.oaks))return null;let e=n.oaks.slice(0,wa).map(Ry).filter(i=>i!==null),t=e[0];return!t||new Set(e.map(({key:i})=>i)).size!==e.length?null:{scene:n.scene,oaks:e,selected:e.find(({key:i})=>i===n.selected)?.key??t.key,arePosesLinked:n.arePosesLinked!==!1,region:Ea(n.region,4)??tr,target:Cy(n.target)}}function Cy(n){if(!xo(n))return null;if(typeof n.object=="string")return{object:n.object};let[e,t]=[Ea(n.minimum,3),Ea(n.maximum,3)];return e&&t?{minimum:e,maximum:t}:null}function Ry(n){if(!xo(n)||typeof n.key!="string")return null;let e=Py(n.state);return e&&{key:n.key,isHidden:n.isHidden===!0,state:e}}function Py(n){if(!xo(n)||!xo(n.pose)||typeof n.model!="string")return null;let e=Ea(n.pose.position,3),t=Ea(n.pose.quaternion,4);if(!e||!t)return null;let i=o=>typeof o=="string"?o:null,s=(o,a)=>Number.isFinite(o)?o:a,r=o=>{let a=xo(o)?Object.entries(o).filter(([,l])=>i(l)!==null):[];return Object.fromEntries(a)};return{model:n.model,calibration:i(n.calibration),pose:{position:e,quaternion:t},sensor:i(n.sensor)??"",lens:n.lens==="fisheye"?"fisheye":"pinhole",engine:i(n.engine)??"",preset:i(n.preset),filters:Array.isArray(n.filters)?n.filters.filter(o=>typeof o=="string"):null,parameters:r(n.parameters),extendedDisparity:n.extendedDisparity===!0,seed:s(n.seed,0),deviceSeed:Number.isFinite(n.deviceSeed)?n.deviceSeed:null,populationSeed:Number.isFinite(n.populationSeed)?n.populationSeed:null,drift:r(n.drift),projector:s(n.projector,1),ambient:s(n.ambient,1)}}var Iy=400,Ly=4,tc=class{document;display;catalog;scene=new Bt(null);frames=new Bt(new Map);rejections=new Bt(new Map);connection=new Bt("connecting");hover=new Bt(null);probe=new Bt(null);notices=new Bt([]);calibrations=new Bt(new Map);lastNotice=0;loading="";constructor(e,t){this.catalog=new Bt(e);let i=Hm(),s=wd(location.hash,i);this.display=new Bt(s?.display??i),this.document=new ec(s?.document??qm(e,t.id,t.pose)),this.document.get().scene===t.id&&this.scene.set(t),this.followAddress(),this.display.subscribe(()=>Wm(this.display.get())),this.document.subscribe(()=>{this.followScene()}),this.followScene()}change(e,t){let{selected:i}=this.document.get();this.document.commit(`${i}/${e}`,s=>nr(s,i,t))}show(e){this.display.update(t=>({...t,...e}))}notify(e,t,i=[]){let s={id:++this.lastNotice,level:e,text:t,findings:i};this.notices.update(r=>[...r.filter(o=>o.text!==t),s].slice(-Ly))}report(e,t){let i=t instanceof Error?t.message:String(t);this.notify("error",`${e}: ${i}`,t instanceof go?t.findings:[])}dismiss(e){this.notices.update(t=>t.filter(i=>i.id!==e))}link(){let e=Qm({document:this.document.get(),display:this.display.get()});return`${location.origin}${location.pathname}${e}`}async restart(){let{version:e}=this.catalog.get();this.catalog.set(await hn.catalog()),this.catalog.get().version!==e&&this.notify("warning","The server has another version now. Reload the page."),this.loading="",this.scene.set(null),await this.followScene()}async followScene(){let{scene:e}=this.document.get();if(!(e===this.scene.get()?.id||e===this.loading)){this.loading=e;try{let t=await hn.scene(e);this.document.get().scene===e&&this.scene.set(t)}catch(t){this.document.get().scene===e&&await this.replaceScene(t)}finally{this.loading===e&&(this.loading="")}}}async replaceScene(e){let t=this.catalog.get().scene;if(!(e instanceof go)||this.document.get().scene===t){this.connection.get()==="open"&&this.report("The scene cannot be loaded",e);return}let{oaks:i}=this.document.get();this.notify("warning","The server does not have the scene of this state; drop its file onto the page again.");let s=await hn.scene(t),r=i.map(o=>({...o,state:{...o.state,pose:s.pose}}));this.document.reset({...this.document.get(),scene:t,oaks:r,target:null}),this.scene.set(s)}followAddress(){let e=0,t=location.hash,i=()=>{t=new URL(this.link()).hash,history.replaceState(null,"",t)},s=()=>{clearTimeout(e),e=window.setTimeout(i,Iy)};this.document.subscribe(s),this.display.subscribe(s),addEventListener("hashchange",()=>{let r=location.hash===t?null:wd(location.hash,this.display.get());r&&(this.display.set(r.display),this.document.commit("link",()=>r.document))})}hasDepth(e){return(gi(this.catalog.get(),e.model)?.depthSensors.length??0)>0}};var Ed=fm(null);function He(){let n=Bm(Ed);if(!n)throw new Error("There is no studio above this component.");return n}function Ta(n){if(n==null||!Number.isFinite(n))return"–";let e=Math.abs(n);return e<.001?`${(n*1e3).toFixed(3)} mm`:e<.1?`${(n*1e3).toFixed(1)} mm`:`${n.toFixed(3)} m`}function ir(n){let e=sr(n,!0);return e==="–"?"–":`${e} mm`}function Pr(n){return n==null||!Number.isFinite(n)?"–":(n*100).toFixed(1)}function sr(n,e=!1){if(n==null||!Number.isFinite(n))return"–";let t=Math.abs(n*1e3).toFixed(1);return Number(t)===0?t:`${n<0?"−":e?"+":""}${t}`}function jm(n){let e=sr(n);return e==="–"?"–":`${e} mm`}function yo(n){return n==null||!Number.isFinite(n)?"–":`${(n*100).toFixed(1)} %`}function vn(n){let e=n.replace(/[_-]+/g," ").replace(/([a-z0-9])([A-Z])/g,(t,i,s)=>`${i} ${s.toLowerCase()}`);return e.charAt(0).toUpperCase()+e.slice(1)}function eg(n){return n.replaceAll("-","‑")}function Td(n){return n<1e6?`${(n/1e3).toFixed(0)} kB`:`${(n/1e6).toFixed(0)} MB`}function Ad(n){if(!(n>0))return 0;let e=10**Math.floor(Math.log10(n)),t=[1,2,5,10].find(i=>n<=i*e*1.0001)??10;return Number((t*e).toPrecision(3))}async function nc(n,e){for(let t of e){let i=n.catalog.get().maxUploadBytes;if(t.size>i){n.notify("error",`${t.name} has ${Td(t.size)}, more than the ${Td(i)} that can be opened here; give it on the command line: oaktwin studio ${t.name}`);continue}try{Dy(t)?Fy(n,await hn.openCalibration(t)):Ny(n,await hn.openScene(t))}catch(s){n.report("Not opened",s)}}}function Dy(n){return n.name.toLowerCase().endsWith(".json")}function Ny(n,e){n.document.commit("scene",i=>({...i,scene:e.id,oaks:i.oaks.map(s=>({...s,state:{...s.state,pose:e.pose}})),target:null}));let t=e.findings.some(({level:i})=>i!=="note")?"warning":"note";n.notify(t,`${e.name}: ${e.triangles.toLocaleString("en")} triangles.`,e.findings)}function Fy(n,e){if(n.calibrations.set(new Map(n.calibrations.get()).set(e.id,e)),e.findings.some(({level:i})=>i==="error")){n.notify("error",`${e.name} has errors and is not used.`,e.findings);return}let t=e.model===null?void 0:gi(n.catalog.get(),e.model);n.document.commit("calibration",i=>nr(i,i.selected,s=>({...t&&t.name!==s.model?Jl(s,t):s,calibration:e.id,populationSeed:null}))),n.notify("note",`${e.name} calibrates the selected OAK${t?`, an ${t.name}`:""}.`,e.findings)}var Uy=Symbol.for("pv"),Oy=0;function _(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Uy,__v:--Oy,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),kt.vnode&&kt.vnode(c),c}var ky={add:"M8 3v10M3 8h10",close:"M4 4l8 8M12 4l-8 8",copy:"M6 6h7v7H6zM3 10V3h7",down:"M8 3v10M4 9l4 4 4-4",up:"M8 13V3M4 7l4-4 4 4",undo:"M6 3L3 6l3 3M3 6h6a4 4 0 010 8H6",redo:"M10 3l3 3-3 3M13 6H7a4 4 0 000 8h3",eye:"M1.5 8S4 3.5 8 3.5 14.5 8 14.5 8 12 12.5 8 12.5 1.5 8 1.5 8zM8 6a2 2 0 100 4 2 2 0 000-4z",hidden:"M2 2l12 12M1.5 8S4 3.5 8 3.5 14.5 8 14.5 8 12 12.5 8 12.5 1.5 8 1.5 8z",theme:"M8 2.5a5.5 5.5 0 100 11zM8 2.5a5.5 5.5 0 010 11",help:"M6 6a2 2 0 113 1.7c-.7.4-1 .8-1 1.8M8 12v.5M8 1.5a6.5 6.5 0 100 13 6.5 6.5 0 000-13z",open:"M2 13V3h4l1.5 2H14v8z",share:"M7 9l2-2M6.5 5.5L8 4a2.8 2.8 0 014 4l-1.5 1.5M9.5 10.5L8 12a2.8 2.8 0 01-4-4l1.5-1.5",download:"M8 2v8M4.5 7L8 10.5 11.5 7M2.5 13.5h11",reset:"M3 8a5 5 0 105-5H5M7 1L5 3l2 2",left:"M2 3h12v10H2zM6 3v10",right:"M2 3h12v10H2zM10 3v10",link:"M6 4H4a3 3 0 000 8h2M10 4h2a3 3 0 010 8h-2M5 8h6",move:"M8 1.5v13M1.5 8h13M6 3.5l2-2 2 2M6 12.5l2 2 2-2M3.5 6l-2 2 2 2M12.5 6l2 2-2 2",turn:"M13 5.5A5.5 5.5 0 108 13.5M13 2v3.5H9.5",home:"M2.5 8L8 3l5.5 5M4 7v6h8V7",camera:"M2 5h3l1-1.5h4L11 5h3v8H2zM8 7a2 2 0 100 4 2 2 0 000-4z",warning:"M8 2L1.5 13.5h13zM8 6v4M8 11.5v.6",dice:"M3 3h10v10H3zM6 6h.1M10 10h.1M8 8h.1M10 6h.1M6 10h.1"};function ic({name:n}){return _("svg",{class:"icon",viewBox:"0 0 16 16","aria-hidden":"true",children:_("path",{d:ky[n]})})}function Ve({icon:n,label:e,onClick:t,isNamed:i=!n,isOn:s,isDisabled:r=!1,class:o="",tip:a,testId:l}){return _("button",{type:"button",class:`button ${i?"":"square"} ${o}`,"aria-label":i?void 0:e,"aria-pressed":s,disabled:r,"data-tip":a??(i?void 0:e),"data-testid":l,onClick:t,children:[n&&_(ic,{name:n}),i&&_("span",{children:e})]})}function ui({label:n,value:e,options:t,onChange:i,isLabelled:s=!0,testId:r}){return _("label",{class:"field",children:[_("span",{class:s?"name":"sr-only",children:n}),_("select",{value:e,"data-testid":r,onChange:o=>i(o.currentTarget.value),children:t.map(o=>_("option",{value:o.value,selected:o.value===e,children:o.title},o.value))})]})}function Wi({label:n,isOn:e,onChange:t,tip:i,isDisabled:s=!1}){return _("label",{class:"check","data-tip":i,children:[_("input",{type:"checkbox",checked:e,disabled:s,onChange:r=>t(r.currentTarget.checked)}),_("span",{children:n})]})}function sc({label:n,text:e,onText:t,onStep:i,problem:s,isLabelled:r=!0,tip:o,unit:a,testId:l}){let[c,u]=Pt(null),[d,h]=Pt(null),f=Tt(null),g=d??s;Ht(()=>{document.activeElement!==f.current&&(u(null),h(null))},[e]);let y=()=>{u(null),h(null)};return _("label",{class:"field","data-tip":o,children:[_("span",{class:r?"name":"sr-only",children:n}),_("span",{class:"with-unit",children:[_("input",{ref:f,type:"text",inputMode:i?"decimal":"text",spellcheck:!1,autocomplete:"off",value:c??e,"aria-invalid":g?"true":void 0,"data-testid":l,onInput:m=>{u(m.currentTarget.value),h(t(m.currentTarget.value))},onBlur:y,onKeyDown:m=>{m.key==="Enter"&&y(),!(!i||m.key!=="ArrowUp"&&m.key!=="ArrowDown")&&(m.preventDefault(),y(),i((m.key==="ArrowUp"?1:-1)*(m.shiftKey?.1:1)))}}),a&&_("span",{class:"unit",children:a})]}),g&&_("span",{class:"problem",role:"alert",children:g})]})}function Rn({value:n,onChange:e,step:t,digits:i,minimum:s=-1e6,maximum:r=1e6,...o}){let a=c=>{let u=Number(c.trim().replace(",","."));return c.trim()===""||!Number.isFinite(u)?"Enter a number.":u<s?`Enter at least ${s}.`:u>r?`Enter at most ${r}.`:(e(u),null)},l=c=>{let u=Number((n+c*t).toFixed(i+1));e(Math.min(r,Math.max(s,u)))};return _(sc,{...o,text:String(Number(n.toFixed(i))),onText:a,onStep:l})}function en({title:n,children:e,actions:t,isOpen:i=!0,testId:s}){let[r,o]=Pt(i);return _("section",{class:"section","data-testid":s,children:[_("div",{class:"section-head",children:[_("h2",{children:_("button",{type:"button",class:"fold","aria-expanded":r,onClick:()=>o(!r),children:n})}),t&&_("div",{class:"actions",children:t})]}),r&&_("div",{class:"section-body",children:e})]})}function rc({title:n,children:e,onClose:t}){let i=Tt(null);return hs(()=>{let s=i.current;return s?.showModal(),()=>s?.close()},[]),_("dialog",{ref:i,class:"dialog","aria-label":n,onClose:t,onClick:s=>s.target===i.current&&t(),children:[_("div",{class:"dialog-head",children:[_("h2",{children:n}),_(Ve,{icon:"close",label:"Close",onClick:t})]}),_("div",{class:"dialog-body",children:e})]})}var By=[["Everywhere",[["Ctrl+Z, Ctrl+Shift+Z","Undo, redo"],["1, 2","Show or hide the controls, the numbers"],["G, R","Handles that move, turn the OAK"],["P","Points: none, true, measured, both"],["Home","Look at the OAK"],["C","Look from the OAK"],["F","Fly the OAK: it moves with the view"],["[, ]","Select the previous, next OAK"],["Escape","Close, or stop probing"],["?","This list"]]],["3D view, after a click into it or with Tab",[["Drag","Orbit; with Ctrl turn the head; with Shift or the right button pan"],["Wheel","Zoom"],["Drag a pink handle","Resize or move the box of the region; with Shift move it up and down"],["Double click","Put a point into the centre"],["W A S D, Q E","Fly; with Shift faster"],["Arrow keys","Move the OAK by 5 cm; with Shift by 5 mm"],["Page up, page down","Raise, lower the OAK"],["Alt+arrow keys","Turn, tilt the OAK by 2°; with Shift by 0.2°"]]],["Images",[["Mouse, arrow keys","Probe a pixel"],["Drag","Rectangle for the statistics"]]],["Number fields",[["Up, down","One step; with Shift a tenth"]]]];function tg({onClose:n}){return _(rc,{title:"Keys",onClose:n,children:_("div",{class:"keys",children:By.map(([e,t])=>_("section",{children:[_("h3",{children:e}),_("dl",{children:t.map(([i,s])=>_("div",{children:[_("dt",{children:_("kbd",{children:i})}),_("dd",{children:s})]},i))})]},e))})})}var zy=4e3,ng={depth:[0,5],error:.05};function oc(n,e){let t=[...n];return{depth:e.depthRange??Gy(t),error:e.errorRange??Hy(t,e.errorUnit)}}function Vy(n){return n.pictures.get("reference")??n.pictures.get("depth")}function Gy(n){let e=[];for(let o of n){let a=Vy(o)?.data??o.pictures.get("sensor")?.data;if(!a)continue;let l=Math.max(1,Math.floor(a.length/zy));for(let c=0;c<a.length;c+=l)a[c]&&e.push(a[c])}if(e.length===0)return ng.depth;e.sort((o,a)=>o-a);let t=o=>e[Math.floor(o*(e.length-1))]/1e3,[i,s]=[t(.01),t(.99)],r=Math.max(Ad((s-i)/20),.01);return[Number((Math.floor(i/r)*r).toFixed(3)),Number((Math.ceil(s/r)*r).toFixed(3))]}function Hy(n,e){let t=n.map(({header:{statistics:i}})=>e==="mm"?i.p95AbsoluteErrorM??0:(i.medianAbsoluteErrorPercent??0)*3);return Ad(Math.max(0,...t))||(e==="mm"?ng.error:5)}function ig({kinds:n,scales:e}){let t=n.includes("depth")||n.includes("sensor")||n.includes("confidence");return _("div",{class:"legend",children:[t&&_(Wy,{scales:e}),n.includes("error")&&_(Xy,{scales:e}),n.includes("reason")&&_(qy,{}),(t||n.includes("error"))&&_("span",{class:"swatch-label",children:[_("span",{class:"swatch hatch"}),"no value"]})]})}function Wy({scales:n}){let{studio:e}=He(),{depthMap:t,depthRange:i}=Ae(e.display),[s,r]=n.depth;return _("div",{class:"scale",role:"group","aria-label":"Depth scale",children:[_("span",{class:"scale-name",children:"Depth"}),_(Rn,{label:"Nearest depth",isLabelled:!1,value:s,minimum:0,maximum:r-.001,step:.1,digits:3,onChange:o=>e.show({depthRange:[o,r]})}),_(sg,{bytes:fo(t)}),_(Rn,{label:"Farthest depth",isLabelled:!1,value:r,minimum:s+.001,maximum:65.535,step:.1,digits:3,unit:"m",onChange:o=>e.show({depthRange:[s,o]})}),_(Ve,{label:"Auto",class:"chip",tip:"Follow the images",isOn:i===null,onClick:()=>e.show({depthRange:i?null:n.depth})}),_(ui,{label:"Colour map",isLabelled:!1,value:t,options:bm.map(({map:o,title:a})=>({value:o,title:a})),onChange:o=>e.show({depthMap:o}),testId:"depth-map"})]})}function Xy({scales:n}){let{studio:e}=He(),{errorUnit:t,errorRange:i}=Ae(e.display),s=t==="mm"?1e3:1,r=()=>e.show({errorUnit:t==="mm"?"%":"mm",errorRange:null});return _("div",{class:"scale",role:"group","aria-label":"Error scale",children:[_("span",{class:"scale-name",children:"Error"}),_("span",{class:"end",children:"too near"}),_(sg,{bytes:po()}),_("span",{class:"end",children:"too far"}),_("span",{class:"end",children:"±"}),_(Rn,{label:"End of the error scale",isLabelled:!1,value:n.error*s,minimum:.01,maximum:65535,step:t==="mm"?5:.5,digits:2,onChange:o=>e.show({errorRange:o/s})}),_(Ve,{label:t,class:"chip",tip:"Switch between millimetres and percent",onClick:r,testId:"error-unit"}),_(Ve,{label:"Auto",class:"chip",tip:"Follow the images",isOn:i===null,onClick:()=>e.show({errorRange:i?null:n.error})})]})}function qy(){let{studio:n}=He(),{reasons:e}=Ae(n.catalog),t=Ae(n.frames),i=s=>[...t.values()].some(({header:r})=>(r.statistics.reasons[s]??0)>0);return _("div",{class:"reasons-legend",role:"group","aria-label":"Reasons",children:e.filter(({code:s})=>s===0||i(s)).map(({code:s,name:r,documentation:o})=>_("span",{class:"swatch-label","data-tip":o,children:[_("span",{class:"swatch",style:{background:on(er(s))}}),vn(r)]},s))})}function sg({bytes:n}){let e=Tt(null);return hs(()=>{let t=new ImageData(new Uint8ClampedArray(n),us,1);e.current?.getContext("2d")?.putImageData(t,0,0)},[n]),_("canvas",{ref:e,class:"gradient",width:us,height:1})}var ac=Math.PI/180,rg=[-Math.SQRT1_2,0,0,Math.SQRT1_2];function bo([n,e,t,i],[s,r,o,a]){return[i*s+n*a+e*o-t*r,i*r-n*o+e*a+t*s,i*o+n*r-e*s+t*a,i*a-n*s-e*r-t*o]}function og([n,e,t,i]){return[-n,-e,-t,i]}function Aa(n,[e,t,i]){let[s,r,o]=bo(bo(n,[e,t,i,0]),og(n));return[s,r,o]}function ag(n){let e=Math.hypot(...n)||1;return[n[0]/e,n[1]/e,n[2]/e,n[3]/e]}function Cd(n,e){let t=e*ac/2,i=[0,0,0,Math.cos(t)];return i[n]=Math.sin(t),i}function lc(n){return n==="z"?[0,0,1]:[0,1,0]}function cc({yaw:n,pitch:e,roll:t},i){let s=bo(bo(Cd(2,n),Cd(1,e)),Cd(0,t));return ag(i==="z"?s:bo(rg,s))}function ds(n,e){let[t,i,s,r]=ag(e==="z"?n:bo(og(rg),n)),o=Math.max(-1,Math.min(1,2*(r*i-s*t)));return{yaw:Math.atan2(2*(r*s+t*i),1-2*(i*i+s*s))/ac,pitch:Math.asin(o)/ac,roll:Math.atan2(2*(r*t+i*s),1-2*(t*t+i*i))/ac}}function uc(n,[e,t,i],s){let r=cc({yaw:ds(n.quaternion,s).yaw,pitch:0,roll:0},s),[o,a,l]=Aa(r,[e,t,i]),[c,u,d]=n.position;return{...n,position:[c+o,u+a,d+l]}}function hc(n,e,t){let i=ds(n.quaternion,t),s=Math.max(-90,Math.min(90,i.pitch+(e.pitch??0))),r={yaw:i.yaw+(e.yaw??0),pitch:s,roll:i.roll+(e.roll??0)};return{...n,quaternion:cc(r,t)}}function lg({oak:n,kind:e}){let{studio:t}=He(),i=Ps(t.document,c=>c.region),s=i.every((c,u)=>c===tr[u]),[r,o,a,l]=i;return _(xt,{children:[!s&&_("div",{class:"region",style:{left:`${r*100}%`,top:`${o*100}%`,width:`${(a-r)*100}%`,height:`${(l-o)*100}%`}}),_(Yy,{oak:n,kind:e})]})}function Yy({oak:n,kind:e}){let{studio:t}=He(),i=Ae(t.hover),s=Ae(t.probe),r=Ae(t.catalog);if(!i)return null;let o=t.frames.get().get(n),a=o&&_i(r,o.state);if(!o||!a)return null;let l=s?.point?$y(o,a,s.point):null,c=i.oak===n?{x:i.x,y:i.y,z:l?.z??null}:l;if(!c||c.x<0||c.x>1||c.y<0||c.y>1)return null;let u=e==="right"?Zy(o,a.baselineM,c.z):0;if(u===null)return null;let d=i.oak!==n;return _("div",{class:`cross ${d?"other":""}`,style:{left:`${(c.x-u)*100}%`,top:`${c.y*100}%`}})}function $y({header:n,state:e},t,i){let[s,r,o,a]=e.pose.quaternion,{position:l}=e.pose,c=Aa([-s,-r,-o,a],[i[0]-l[0],i[1]-l[1],i[2]-l[2]]),u=t.bodyFromCamera,d=c.map((y,p)=>y-(u[p*4+3]??0)),h=y=>[0,1,2].reduce((p,m)=>p+(u[m*4+y]??0)*(d[m]??0),0),f=h(2);if(f<=0)return null;let g=(y,p)=>.5+y/(2*f*Math.tan(p*Math.PI/360));return{x:g(h(0),n.hfovDeg),y:g(h(1),n.vfovDeg),z:f}}function Zy({header:n},e,t){return!e||!t?null:e/(t*2*Math.tan(n.hfovDeg*Math.PI/360))}var Ky=5;function ug({oak:n,index:e,kind:t,other:i,width:s,scales:r}){let{studio:o}=He(),a=Ps(o.frames,f=>f.get(n.key)),l=Ps(o.rejections,f=>f.get(n.key)),c=Ps(o.display,f=>f.wipeAt),u=a?jy(a):1.6,d=f=>Ui.find(g=>g.kind===f)?.title??f,h=Math.round(s/u);return _("figure",{class:`panel ${l&&a?"stale":""}`,"data-testid":`panel-${n.key}-${t}`,children:[_("figcaption",{children:[_("span",{class:"dot-small",style:{background:on(Qn(e))}}),_("span",{class:"panel-title",children:i?`${d(t)} | ${d(i)}`:d(t)}),_("span",{class:"panel-oak",children:n.state.model}),_("span",{class:"spring"}),a&&_("span",{class:"panel-fact",children:eb(t,a)})]}),_(ib,{oak:n.key,label:`${d(t)} of ${n.state.model}`,width:s,height:h,children:[_(cg,{oak:n.key,kind:t,frame:a,width:s,height:h,scales:r}),i&&_("div",{class:"wiped",style:{clipPath:`inset(0 0 0 ${c*100}%)`},children:_(cg,{oak:n.key,kind:i,frame:a,width:s,height:h,scales:r})}),i&&_(Jy,{at:c,width:s}),_(lg,{oak:n.key,kind:t}),l&&a&&_("p",{class:"stale-note",children:`Not measured: ${l.error}`}),!a&&_("p",{class:"empty",children:Qy(l?.error,o.hasDepth(n.state),n.state.model)})]})]})}function Jy({at:n,width:e}){let{studio:t}=He(),i=s=>{s.stopPropagation();let r=s.clientX,o=a=>t.show({wipeAt:Math.max(0,Math.min(1,n+(a.clientX-r)/e))});addEventListener("pointermove",o),addEventListener("pointerup",()=>removeEventListener("pointermove",o),{once:!0})};return _("div",{class:"edge",style:{left:`${n*100}%`},onPointerDown:i})}function Qy(n,e,t){return n||(e?"Measuring…":`${t} has no depth sensor.`)}function jy(n){let e=n.pictures.get("sensor")??[...n.pictures.values()][0];return e?e.width/e.height:1.6}function eb(n,{header:{statistics:e}}){return n==="sensor"||n==="reason"?`${yo(e.fillRate)} filled`:n==="error"?`median ${ir(e.medianErrorM)}`:""}function cg({oak:n,kind:e,frame:t,width:i,height:s,scales:r}){let{painter:o,repaint:a,studio:l,signals:c}=He(),u=Ae(l.display),d=Ae(a),h=Tt(null),[f,g]=Pt(!1),y=t?.pictures.get(e==="error"?"sensor":e),p=Math.min(devicePixelRatio*i,y?.width??640)/i,{depthMap:m,errorUnit:x}=u,E=e==="error"||e==="depth"?t?.pictures.get("reference")??t?.pictures.get("depth"):void 0,S=e==="error"?[r.error]:e==="depth"||e==="sensor"?r.depth:[];return hs(()=>{let R=h.current;if(!R||!t)return;let[C,v]=[Math.max(1,Math.round(i*p)),Math.max(1,Math.round(s*p))];R.width!==C&&(R.width=C),R.height!==v&&(R.height=v),g(!o.paint(R,{oak:n,kind:e,frame:t,display:u,scales:r,empty:nb()})),c.painted++},[y,E,i,s,p,S[0],S[1],m,x,e,d,u.theme,t===void 0]),_(xt,{children:[_("canvas",{ref:h,class:"picture"}),f&&t&&_("p",{class:"empty",children:tb(e,t)})]})}function tb(n,e){let{engine:t,model:i}=e.state;return(Ui.find(r=>r.kind===n)?.images??[]).every(r=>e.requested.includes(r))?n==="confidence"?`${t} makes no confidence.`:n==="left"||n==="right"?`${i} has no stereo pair here.`:"This image is not available.":"Measuring…"}function nb(){let n=getComputedStyle(document.documentElement);return["--empty","--empty-line"].flatMap(e=>{let t=Number.parseInt(n.getPropertyValue(e).trim().slice(1),16);return[(t>>16)/255,(t>>8&255)/255,(t&255)/255]})}function ib({oak:n,label:e,width:t,height:i,children:s}){let{studio:r}=He(),o=Tt(null),a=Tt(()=>{});Ht(()=>()=>a.current(),[]);let l=h=>{let f=o.current?.getBoundingClientRect()??new DOMRect(0,0,1,1),g=y=>Math.max(0,Math.min(.99999,y));return[g((h.clientX-f.left)/f.width),g((h.clientY-f.top)/f.height)]},c=h=>{let[f,g]=l(h);r.hover.set({oak:n,x:f,y:g})},u=h=>{if(h.button!==0)return;let[f,g]=l(h),[y,p]=[h.clientX,h.clientY],m=E=>{if(Math.hypot(E.clientX-y,E.clientY-p)<Ky)return;let[S,R]=l(E),C=[Math.min(f,S),Math.min(g,R),Math.max(f,S),Math.max(g,R)];r.document.commit("region",v=>({...v,region:C}))},x=()=>{removeEventListener("pointermove",m),removeEventListener("pointerup",x)};a.current=x,addEventListener("pointermove",m),addEventListener("pointerup",x)},d=h=>{let[f,g]={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[h.key]??[0,0];if(f===0&&g===0)return;h.preventDefault(),h.stopPropagation();let y=h.shiftKey?.002:.02,{x:p,y:m}=r.hover.get()??{x:.5,y:.5},x=E=>Math.max(0,Math.min(.99999,E));r.hover.set({oak:n,x:x(p+(f??0)*y),y:x(m+(g??0)*y)})};return _("div",{ref:o,class:"surface",role:"application","aria-label":`${e}. Arrow keys move the probed pixel.`,tabIndex:0,style:{width:`${t}px`,height:`${i}px`},onPointerMove:c,onPointerDown:u,onKeyDown:d,children:s})}var sb=1.7,hg=6,dg=1.6,rb=150;function ob(n,e,t,i,s){let r=i*s,o=i>1&&s>1?[s,i]:Array.from({length:r},(c,u)=>u+1),a=sb*Number.parseFloat(getComputedStyle(document.documentElement).fontSize),l={count:1,width:0};for(let c of o){let u=Math.ceil(r/c),d=Math.min((n-hg*(c-1))/c,((e-hg*(u-1))/u-a)*t);d>l.width&&(l={count:c,width:d})}return{count:l.count,width:Math.max(rb,Math.floor(l.width))}}function fg(){let{studio:n}=He(),e=Ae(n.display),t=Ae(n.frames),{oaks:i}=Ae(n.document),s=i.filter(y=>!y.isHidden),r=Rr(()=>oc(t.values(),e),[t,e]),o=e.wipe?[e.wipe.left]:Ui.map(({kind:y})=>y).filter(y=>e.panels.includes(y)),a=Tt(null),[l,c]=Pt({width:800,height:300});hs(()=>{let y=a.current;if(!y)return;let p=new ResizeObserver(()=>c({width:y.clientWidth-16,height:y.clientHeight-12}));return p.observe(y),()=>p.disconnect()},[]);let u=[...t.values()].map(({pictures:y})=>y.get("sensor")).map(y=>y?y.width/y.height:dg),d=u.length?Math.min(...u):dg,h=ob(l.width,l.height,d,s.length,Math.max(o.length,1)),g=s.length>1&&o.length>1&&h.count===s.length&&h.count!==o.length?o.flatMap(y=>s.map(p=>[p,y])):s.flatMap(y=>o.map(p=>[y,p]));return _("section",{class:"images","aria-label":"Images",children:[_(lb,{}),_("div",{class:"panels",ref:a,children:[_("div",{class:"grid",style:{gridTemplateColumns:`repeat(${h.count}, ${h.width}px)`},children:g.map(([y,p])=>_(ug,{oak:y,index:i.indexOf(y),kind:p,other:e.wipe?.right??null,width:h.width,scales:r},`${y.key}/${p}`))}),g.length===0&&_("p",{class:"hint pad",children:"Choose at least one image above."})]}),_(ig,{kinds:[...e.wipe?[e.wipe.left,e.wipe.right]:o,...ab(e)],scales:r})]})}function ab({cloud:n,cloudColor:e}){return n==="none"||e==="oak"?[]:[e]}function lb(){let{studio:n}=He(),e=Ae(n.display),t=r=>{let o=e.panels.includes(r)?e.panels.filter(a=>a!==r):[...e.panels,r];n.show({panels:o})},i=Ui.map(({kind:r,title:o})=>({value:r,title:o})),{wipe:s}=e;return _("div",{class:"bar",role:"toolbar","aria-label":"Images that are shown",children:[s?_(xt,{children:[_(ui,{label:"Left of the edge",isLabelled:!1,value:s.left,options:i,onChange:r=>n.show({wipe:{...s,left:r}})}),_("input",{type:"range",class:"wipe-at",min:0,max:1,step:.01,"aria-label":"Edge of the wipe",value:e.wipeAt,onInput:r=>n.show({wipeAt:Number(r.currentTarget.value)})}),_(ui,{label:"Right of the edge",isLabelled:!1,value:s.right,options:i,onChange:r=>n.show({wipe:{...s,right:r}})})]}):Ui.map(({kind:r,title:o,help:a})=>_(Ve,{label:o,class:"chip",tip:a,isOn:e.panels.includes(r),onClick:()=>t(r),testId:`show-${r}`},r)),_("span",{class:"spring"}),_(Ve,{label:"Wipe",class:"chip",tip:"Two images in one panel with a movable edge",isOn:s!==null,onClick:()=>n.show({wipe:s?null:{left:"depth",right:"sensor"}})}),_(ui,{label:"Image size at rest",isLabelled:!1,value:e.fullSize,options:vo.map(({size:r,title:o})=>({value:r,title:o})),onChange:r=>n.show({fullSize:r}),testId:"full-size"})]})}var cb="uplot",ub="u-hz",hb="u-vt",db="u-title",fb="u-wrap",pb="u-under",mb="u-over",gb="u-axis",Dr="u-off",_b="u-select",vb="u-cursor-x",xb="u-cursor-y",yb="u-cursor-pt",bb="u-legend",Sb="u-live",Mb="u-inline",wb="u-series",Eb="u-marker",pg="u-label",Tb="u-value",Ra="width",Pa="height";var mg="bottom",So="left",Rd="right",qd="#000",gg=qd+"0",Pd="mousemove",_g="mousedown",Id="mouseup",vg="mouseenter",xg="mouseleave",yg="dblclick",Ab="resize",Cb="scroll",bg="change",gc="dppxchange",Yd="--",Ro=typeof window<"u",Ud=Ro?document:null,wo=Ro?window:null,Rb=Ro?navigator:null,It,dc;function Od(){let n=devicePixelRatio;It!=n&&(It=n,dc&&Bd(bg,dc,Od),dc=matchMedia(`(min-resolution: ${It-.001}dppx) and (max-resolution: ${It+.001}dppx)`),Nr(bg,dc,Od),wo.dispatchEvent(new CustomEvent(gc)))}function Ei(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function kd(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function tn(n,e,t){n.style[e]=t+"px"}function Xi(n,e,t,i){let s=Ud.createElement(n);return e!=null&&Ei(s,e),t?.insertBefore(s,i),s}function Oi(n,e){return Xi("div",n,e)}var Sg=new WeakMap;function fs(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Sg.get(n);r!=o&&(n.style.transform=r,Sg.set(n,r),e<0||t<0||e>i||t>s?Ei(n,Dr):kd(n,Dr))}var Mg=new WeakMap;function wg(n,e,t){let i=e+t,s=Mg.get(n);i!=s&&(Mg.set(n,i),n.style.background=e,n.style.borderColor=t)}var Eg=new WeakMap;function Tg(n,e,t,i){let s=e+""+t,r=Eg.get(n);s!=r&&(Eg.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var $d={passive:!0},Pb={...$d,capture:!0};function Nr(n,e,t,i){e.addEventListener(n,t,i?Pb:$d)}function Bd(n,e,t,i){e.removeEventListener(n,t,$d)}Ro&&Od();function qi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:Ti((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function e0(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var t0=n=>n!=null,n0=n=>n!=null&&n>0,xc=e0(t0),Ib=e0(n0);function Lb(n,e,t,i=0,s=!1){let r=s?Ib:xc,o=s?n0:t0;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Wt,l??-Wt]}function yc(n,e,t,i){let s=Rg(n),r=Rg(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Is:i0,a=s==1?Ti:ki,l=r==1?ki:Ti,c=a(o(On(n))),u=l(o(On(e))),d=Eo(t,c),h=Eo(t,u);return t==10&&(c<0&&(d=Xt(d,-c)),u<0&&(h=Xt(h,-u))),i||t==2?(n=d*s,e=h*r):(n=a0(n,d),e=bc(e,h)),[n,e]}function Zd(n,e,t,i){let s=yc(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Kd=.1,Ag={mode:3,pad:Kd},La={pad:0,soft:null,mode:0},Db={min:La,max:La};function _c(n,e,t,i){return Sc(t)?Cg(n,e,t):(La.pad=t,La.soft=i?0:null,La.mode=i?3:0,Cg(n,e,Db))}function Ct(n,e){return n??e}function Nb(n,e,t){for(e=Ct(e,0),t=Ct(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Cg(n,e,t){let i=t.min,s=t.max,r=Ct(i.pad,0),o=Ct(s.pad,0),a=Ct(i.hard,-Wt),l=Ct(s.hard,Wt),c=Ct(i.soft,Wt),u=Ct(s.soft,-Wt),d=Ct(i.mode,0),h=Ct(s.mode,0),f=e-n,g=Is(f),y=hi(On(n),On(e)),p=Is(y),m=On(p-g);(f<1e-24||m>10)&&(f=0,(n==0||e==0)&&(f=1e-24,d==2&&c!=Wt&&(r=0),h==2&&u!=-Wt&&(o=0)));let x=f||y||1e3,E=Is(x),S=Eo(10,Ti(E)),R=x*(f==0?n==0?.1:1:r),C=Xt(a0(n-R,S/10),24),v=n>=c&&(d==1||d==3&&C<=c||d==2&&C>=c)?c:Wt,w=hi(a,C<v&&n>=v?v:Yi(v,C)),U=x*(f==0?e==0?.1:1:o),I=Xt(bc(e+U,S/10),24),D=e<=u&&(h==1||h==3&&I>=u||h==2&&I<=u)?u:-Wt,z=Yi(l,I>D&&e<=D?D:hi(D,I));return w==z&&w==0&&(z=100),[w,z]}var Fb=new Intl.NumberFormat(Ro?Rb.language:"en-US"),Jd=n=>Fb.format(n),Ai=Math,mc=Ai.PI,On=Ai.abs,Ti=Ai.floor,Un=Ai.round,ki=Ai.ceil,Yi=Ai.min,hi=Ai.max,Eo=Ai.pow,Rg=Ai.sign,Is=Ai.log10,i0=Ai.log2,Ub=(n,e=1)=>Ai.sinh(n)*e,Ld=(n,e=1)=>Ai.asinh(n/e),Wt=1/0;function Pg(n){return(Is((n^n>>31)-(n>>31))|0)+1}function zd(n,e,t){return Yi(hi(n,e),t)}function s0(n){return typeof n=="function"}function bt(n){return s0(n)?n:()=>n}var Ob=()=>{},r0=n=>n,o0=(n,e)=>e,kb=n=>null,Ig=n=>!0,Lg=(n,e)=>n==e,Bb=/\.\d*?(?=9{6,}|0{6,})/gm,Fr=n=>{if(c0(n)||or.has(n))return n;let e=`${n}`,t=e.match(Bb);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Fr(s)}e${r}`}return Xt(n,i)};function Ir(n,e){return Fr(Xt(Fr(n/e))*e)}function bc(n,e){return Fr(ki(Fr(n/e))*e)}function a0(n,e){return Fr(Ti(Fr(n/e))*e)}function Xt(n,e=0){if(c0(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Un(i)/t}var or=new Map;function l0(n){return((""+n).split(".")[1]||"").length}function Na(n,e,t,i){let s=[],r=i.map(l0);for(let o=e;o<t;o++){let a=On(o),l=Xt(Eo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Xt(u,d);s.push(h),or.set(h,d)}}return s}var Da={},Qd=[],To=[null,null],rr=Array.isArray,c0=Number.isInteger,zb=n=>n===void 0;function Dg(n){return typeof n=="string"}function Sc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Vb(n){return n!=null&&typeof n=="object"}var Gb=Object.getPrototypeOf(Uint8Array),u0="__proto__";function Ao(n,e=Sc){let t;if(rr(n)){let i=n.find(s=>s!=null);if(rr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Ao(n[s],e)}else t=n.slice()}else if(n instanceof Gb)t=n.slice();else if(e(n)){t={};for(let i in n)i!=u0&&(t[i]=Ao(n[i],e))}else t=n;return t}function Pn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=u0&&(Sc(n[s])?Pn(n[s],Ao(i[s])):n[s]=Ao(i[s]))}return n}var Hb=0,Wb=1,Xb=2;function qb(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Yb(n,e){if(Kb(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Jb(o[0])||(o=Zb(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],d=Array(s).fill(void 0),h=e?e[o][c]:Wb,f=[];for(let g=0;g<u.length;g++){let y=u[g],p=r.get(l[g]);y===null?h!=Hb&&(d[p]=y,h==Xb&&f.push(p)):d[p]=y}qb(d,f,s),i.push(d)}}return i}var $b=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Zb(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Kb(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Jb(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=hi(1,Ti((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var h0=["January","February","March","April","May","June","July","August","September","October","November","December"],d0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function f0(n){return n.slice(0,3)}var Qb=d0.map(f0),jb=h0.map(f0),eS={MMMM:h0,MMM:jb,WWWW:d0,WWW:Qb};function Ca(n){return(n<10?"0":"")+n}function tS(n){return(n<10?"00":n<100?"0":"")+n}var nS={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Ca(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ca(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Ca(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ca(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ca(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>tS(n.getMilliseconds())};function jd(n,e){e=e||eS;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?nS[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var iS=new Intl.DateTimeFormat().resolvedOptions().timeZone;function sS(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==iS?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var p0=n=>n%1==0,vc=[1,2,2.5,5],rS=Na(10,-32,0,vc),m0=Na(10,0,32,vc),oS=m0.filter(p0),Lr=rS.concat(m0),ef=`
`,g0="{YYYY}",Ng=ef+g0,_0="{M}/{D}",Ia=ef+_0,fc=Ia+"/{YY}",v0="{aa}",aS="{h}:{mm}",Mo=aS+v0,Fg=ef+Mo,Ug=":{ss}",Lt=null;function x0(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Na(10,0,3,vc).filter(p0):Na(10,-3,0,vc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,g0,Lt,Lt,Lt,Lt,Lt,Lt,1],[s*28,"{MMM}",Ng,Lt,Lt,Lt,Lt,Lt,1],[s,_0,Ng,Lt,Lt,Lt,Lt,Lt,1],[i,"{h}"+v0,fc,Lt,Ia,Lt,Lt,Lt,1],[t,Mo,fc,Lt,Ia,Lt,Lt,Lt,1],[e,Ug,fc+" "+Mo,Lt,Ia+" "+Mo,Lt,Fg,Lt,1],[n,Ug+".{fff}",fc+" "+Mo,Lt,Ia+" "+Mo,Lt,Fg,Lt,1]];function u(d){return(h,f,g,y,p,m)=>{let x=[],E=p>=o,S=p>=r&&p<o,R=d(g),C=Xt(R*n,3),v=Dd(R.getFullYear(),E?0:R.getMonth(),S||E?1:R.getDate()),w=Xt(v*n,3);if(S||E){let U=S?p/r:0,I=E?p/o:0,D=C==w?C:Xt(Dd(v.getFullYear()+I,v.getMonth()+U,1)*n,3),z=new Date(Un(D/n)),G=z.getFullYear(),N=z.getMonth();for(let W=0;D<=y;W++){let $=Dd(G+I*W,N+U*W,1),H=$-d(Xt($*n,3));D=Xt((+$+H)*n,3),D<=y&&x.push(D)}}else{let U=p>=s?s:p,I=Ti(g)-Ti(C),D=w+I+bc(C-w,U);x.push(D);let z=d(D),G=z.getHours()+z.getMinutes()/t+z.getSeconds()/i,N=p/i,W=h.axes[f]._space,$=m/W;for(;D=Xt(D+p,n==1?0:3),!(D>y);)if(N>1){let H=Ti(Xt(G+N,6))%24,j=d(D).getHours()-H;j>1&&(j=-1),D-=j*i,G=(G+N)%24;let ie=x[x.length-1];Xt((D-ie)/p,3)*$>=.7&&x.push(D)}else x.push(D)}return x}}return[l,c,u]}var[lS,cS,uS]=x0(1),[hS,dS,fS]=x0(.001);Na(2,-53,53,[1]);function Og(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function kg(n,e){return(t,i,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,u,d,h,f;return i.map(g=>{let y=n(g),p=y.getFullYear(),m=y.getMonth(),x=y.getDate(),E=y.getHours(),S=y.getMinutes(),R=y.getSeconds(),C=p!=l&&a[2]||m!=c&&a[3]||x!=u&&a[4]||E!=d&&a[5]||S!=h&&a[6]||R!=f&&a[7]||a[1];return l=p,c=m,u=x,d=E,h=S,f=R,C(y)})}}function pS(n,e){let t=jd(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Dd(n,e,t){return new Date(n,e,t)}function Bg(n,e){return e(n)}var mS="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function zg(n,e){return(t,i,s,r)=>r==null?Yd:e(n(i))}function gS(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function _S(n,e){return n.series[e].fill(n,e)}var vS={show:!0,live:!0,isolate:!1,mount:Ob,markers:{show:!0,width:2,stroke:gS,fill:_S,dash:"solid"},idx:null,idxs:null,values:[]};function xS(n,e){let t=n.cursor.points,i=Oi(),s=t.size(n,e);tn(i,Ra,s),tn(i,Pa,s);let r=s/-2;tn(i,"marginLeft",r),tn(i,"marginTop",r);let o=t.width(n,e,s);return o&&tn(i,"borderWidth",o),i}function yS(n,e){let t=n.series[e].points;return t._fill||t._stroke}function bS(n,e){let t=n.series[e].points;return t._stroke||t._fill}function SS(n,e){return n.series[e].points.size}var Nd=[0,0];function MS(n,e,t){return Nd[0]=e,Nd[1]=t,Nd}function pc(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Fd(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var wS={show:!0,x:!0,y:!0,lock:!1,move:MS,points:{one:!1,show:xS,size:SS,width:0,stroke:bS,fill:yS},bind:{mousedown:pc,mouseup:pc,click:pc,dblclick:pc,mousemove:Fd,mouseleave:Fd,mouseenter:Fd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},y0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},tf=Pn({},y0,{filter:o0}),b0=Pn({},tf,{size:10}),S0=Pn({},y0,{show:!1}),nf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',M0="bold "+nf,w0=1.5,Vg={show:!0,scale:"x",stroke:qd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:M0,side:2,grid:tf,ticks:b0,border:S0,font:nf,lineGap:w0,rotate:0},ES="Value",TS="Time",Gg={show:!0,scale:"x",auto:!1,sorted:1,min:Wt,max:-Wt,idxs:[]};function AS(n,e,t,i,s){return e.map(r=>r==null?"":Jd(r))}function CS(n,e,t,i,s,r,o){let a=[],l=or.get(s)||0;t=o?t:Xt(bc(t,s),l);for(let c=t;c<=i;c=Xt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Vd(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Is:i0,u=Ti(c(t));s=Eo(l,u),l==10&&(s=Lr[qi(s,Lr)]);let d=t,h=s*l;l==10&&(h=Lr[qi(h,Lr)]);do a.push(d),d=d+s,l==10&&!or.has(d)&&(d=Xt(d,or.get(s))),d>=h&&(s=d,h=s*l,l==10&&(h=Lr[qi(h,Lr)]));while(d<=i);return a}function RS(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Vd(n,e,hi(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Vd(n,e,hi(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var E0=/./,PS=/[12357]/,IS=/[125]/,Hg=/1/,Gd=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function LS(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),d=l(9,o)-u>=c?E0:l(7,o)-u>=c?PS:l(5,o)-u>=c?IS:Hg;if(d==Hg){let h=On(l(1,o)-u);if(h<c)return Gd(e.slice().reverse(),a.distr,d,ki(c/h)).reverse()}return Gd(e,a.distr,d,1)}function DS(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=On(l(1,o)-l(2,o));return c<a?Gd(e.slice().reverse(),3,E0,ki(a/c)).reverse():e}function NS(n,e,t,i){return i==null?Yd:e==null?"":Jd(e)}var Wg={show:!0,scale:"y",stroke:qd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:M0,side:3,grid:tf,ticks:b0,border:S0,font:nf,lineGap:w0,rotate:0};function FS(n,e){let t=3+(n||1)*2;return Xt(t*e,3)}function US(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=On(o-r),l=n.series[e],c=a/(l.points.space*It);return i[1]-i[0]<=c}var Xg={scale:null,auto:!0,sorted:0,min:Wt,max:-Wt},T0=(n,e,t,i,s)=>s,qg={show:!0,auto:!0,sorted:0,gaps:T0,alpha:1,facets:[Pn({},Xg,{scale:"x"}),Pn({},Xg,{scale:"y"})]},Yg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:T0,alpha:1,points:{show:US,filter:null},values:null,min:Wt,max:-Wt,idxs:[],path:null,clip:null};function OS(n,e,t,i,s){return t/10}var A0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},kS=Pn({},A0,{time:!1,ori:1}),$g={};function C0(n,e){let t=$g[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&($g[n]=t)),t}var Co=1,Hd=2;function Ur(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,f=a.top,g=a.width,y=a.height,p=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,d,p,m,h,f,g,y,wc,Po,Tc,P0,L0):t(s,l,c,u,d,m,p,f,h,y,g,Ec,Io,of,I0,D0)}function sf(n,e){let t=0,i=0,s=Ct(n.bands,Qd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function BS(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ls(n,e,t,i,s,r){return Ur(n,e,(o,a,l,c,u,d,h,f,g,y,p)=>{let m=o.pxRound,x=c.dir*(c.ori==0?1:-1),E=c.ori==0?Po:Io,S,R;x==1?(S=t,R=i):(S=i,R=t);let C=m(d(a[S],c,y,f)),v=m(h(l[S],u,p,g)),w=m(d(a[R],c,y,f)),U=m(h(r==1?u.max:u.min,u,p,g)),I=new Path2D(s);return E(I,w,U),E(I,C,U),E(I,C,v),I})}function Mc(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Tc:of,l=t;for(let d=0;d<n.length;d++){let h=n[d];if(h[1]>h[0]){let f=h[0]-l;f>0&&a(o,l,i,f,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function zS(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function rf(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let d=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let f=r(n[d]),g=h==d?f:r(n[h]),y=d-s;f=o<=0&&y>=0&&y<l?r(n[y]):f;let m=h+s;g=o>=0&&m>=0&&m<l?r(n[m]):g,g>=f&&a.push([f,g])}return a}function Zg(n){return n==0?r0:n==1?Un:e=>Ir(e,n)}function R0(n){let e=n==0?wc:Ec,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Yi(c,a/2,l/2),u=Yi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var wc=(n,e,t)=>{n.moveTo(e,t)},Ec=(n,e,t)=>{n.moveTo(t,e)},Po=(n,e,t)=>{n.lineTo(e,t)},Io=(n,e,t)=>{n.lineTo(t,e)},Tc=R0(0),of=R0(1),P0=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},I0=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},L0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},D0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function N0(n){return(e,t,i,s,r)=>Ur(e,t,(o,a,l,c,u,d,h,f,g,y,p)=>{let{pxRound:m,points:x}=o,E,S;c.ori==0?(E=wc,S=P0):(E=Ec,S=I0);let R=Xt(x.width*It,3),C=(x.size-x.width)/2*It,v=Xt(C*2,3),w=new Path2D,U=new Path2D,{left:I,top:D,width:z,height:G}=e.bbox;Tc(U,I-v,D-v,z+v*2,G+v*2);let N=W=>{if(l[W]!=null){let $=m(d(a[W],c,y,f)),H=m(h(l[W],u,p,g));E(w,$+C,H),S(w,$,H,C,0,mc*2)}};if(r)r.forEach(N);else for(let W=i;W<=s;W++)N(W);return{stroke:R>0?w:null,fill:w,clip:U,flags:Co|Hd}})}function F0(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var VS=F0(Po),GS=F0(Io);function U0(n){let e=Ct(n?.alignGaps,0);return(t,i,s,r)=>Ur(t,i,(o,a,l,c,u,d,h,f,g,y,p)=>{[s,r]=xc(l,s,r);let m=o.pxRound,x=G=>m(d(G,c,y,f)),E=G=>m(h(G,u,p,g)),S,R;c.ori==0?(S=Po,R=VS):(S=Io,R=GS);let C=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Co},w=v.stroke,U=!1;if(r-s>=y*4){let G=de=>t.posToVal(de,c.key,!0),N=null,W=null,$,H,le,Y=x(a[C==1?s:r]),j=x(a[s]),ie=x(a[r]),he=G(C==1?j+1:ie-1);for(let de=C==1?s:r;de>=s&&de<=r;de+=C){let ee=a[de],ve=(C==1?ee<he:ee>he)?Y:x(ee),Ce=l[de];ve==Y?Ce!=null?(H=Ce,N==null?(S(w,ve,E(H)),$=N=W=H):H<N?N=H:H>W&&(W=H)):Ce===null&&(U=!0):(N!=null&&R(w,Y,E(N),E(W),E($),E(H)),Ce!=null?(H=Ce,S(w,ve,E(H)),N=W=$=H):(N=W=null,Ce===null&&(U=!0)),Y=ve,he=G(Y+C))}N!=null&&N!=W&&le!=Y&&R(w,Y,E(N),E(W),E($),E(H))}else for(let G=C==1?s:r;G>=s&&G<=r;G+=C){let N=l[G];N===null?U=!0:N!=null&&S(w,x(a[G]),E(N))}let[D,z]=sf(t,i);if(o.fill!=null||D!=0){let G=v.fill=new Path2D(w),N=o.fillTo(t,i,o.min,o.max,D),W=E(N),$=x(a[s]),H=x(a[r]);C==-1&&([H,$]=[$,H]),S(G,H,W),S(G,$,W)}if(!o.spanGaps){let G=[];U&&G.push(...rf(a,l,s,r,C,x,e)),v.gaps=G=o.gaps(t,i,s,r,G),v.clip=Mc(G,c.ori,f,g,y,p)}return z!=0&&(v.band=z==2?[Ls(t,i,s,r,w,-1),Ls(t,i,s,r,w,1)]:Ls(t,i,s,r,w,z)),v})}function HS(n){let e=Ct(n.align,1),t=Ct(n.ascDesc,!1),i=Ct(n.alignGaps,0),s=Ct(n.extend,!1);return(r,o,a,l)=>Ur(r,o,(c,u,d,h,f,g,y,p,m,x,E)=>{[a,l]=xc(d,a,l);let S=c.pxRound,{left:R,width:C}=r.bbox,v=j=>S(g(j,h,x,p)),w=j=>S(y(j,f,E,m)),U=h.ori==0?Po:Io,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Co},D=I.stroke,z=h.dir*(h.ori==0?1:-1),G=w(d[z==1?a:l]),N=v(u[z==1?a:l]),W=N,$=N;s&&e==-1&&($=R,U(D,$,G)),U(D,N,G);for(let j=z==1?a:l;j>=a&&j<=l;j+=z){let ie=d[j];if(ie==null)continue;let he=v(u[j]),de=w(ie);e==1?U(D,he,G):U(D,W,de),U(D,he,de),G=de,W=he}let H=W;s&&e==1&&(H=R+C,U(D,H,G));let[le,Y]=sf(r,o);if(c.fill!=null||le!=0){let j=I.fill=new Path2D(D),ie=c.fillTo(r,o,c.min,c.max,le),he=w(ie);U(j,H,he),U(j,$,he)}if(!c.spanGaps){let j=[];j.push(...rf(u,d,a,l,z,v,i));let ie=c.width*It/2,he=t||e==1?ie:-ie,de=t||e==-1?-ie:ie;j.forEach(ee=>{ee[0]+=he,ee[1]+=de}),I.gaps=j=c.gaps(r,o,a,l,j),I.clip=Mc(j,h.ori,p,m,x,E)}return Y!=0&&(I.band=Y==2?[Ls(r,o,a,l,D,-1),Ls(r,o,a,l,D,1)]:Ls(r,o,a,l,D,Y)),I})}function Kg(n,e,t,i,s,r,o=Wt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=On(n[l]-n[a]);u<c&&(c=u,o=On(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function WS(n){n=n||Da;let e=Ct(n.size,[.6,Wt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=bt(s),o=1-e[0],a=Ct(e[1],Wt),l=Ct(e[2],1),c=Ct(n.disp,Da),u=Ct(n.each,f=>{}),{fill:d,stroke:h}=c;return(f,g,y,p)=>Ur(f,g,(m,x,E,S,R,C,v,w,U,I,D)=>{let z=m.pxRound,G=t,N=i*It,W=a*It,$=l*It,H,le;S.ori==0?[H,le]=r(f,g):[le,H]=r(f,g);let Y=S.dir*(S.ori==0?1:-1),j=S.ori==0?Tc:of,ie=S.ori==0?u:(Pe,Ke,lt,Me,Gt,We,Ze)=>{u(Pe,Ke,lt,Gt,Me,Ze,We)},he=Ct(f.bands,Qd).find(Pe=>Pe.series[0]==g),de=he!=null?he.dir:0,ee=m.fillTo(f,g,m.min,m.max,de),me=z(v(ee,R,D,U)),ve,Ce,Se,Ye=I,at=z(m.width*It),Xe=!1,pt=null,ht=null,rt=null,sn=null;d!=null&&(at==0||h!=null)&&(Xe=!0,pt=d.values(f,g,y,p),ht=new Map,new Set(pt).forEach(Pe=>{Pe!=null&&ht.set(Pe,new Path2D)}),at>0&&(rt=h.values(f,g,y,p),sn=new Map,new Set(rt).forEach(Pe=>{Pe!=null&&sn.set(Pe,new Path2D)})));let{x0:Yt,size:Mn}=c;if(Yt!=null&&Mn!=null){G=1,x=Yt.values(f,g,y,p),Yt.unit==2&&(x=x.map(lt=>f.posToVal(w+lt*I,S.key,!0)));let Pe=Mn.values(f,g,y,p);Mn.unit==2?Ce=Pe[0]*I:Ce=C(Pe[0],S,I,w)-C(0,S,I,w),Ye=Kg(x,E,C,S,I,w,Ye),Se=Ye-Ce+N}else Ye=Kg(x,E,C,S,I,w,Ye),Se=Ye*o+N,Ce=Ye-Se;Se<1&&(Se=0),at>=Ce/2&&(at=0),Se<5&&(z=r0);let zt=Se>0,zn=Ye-Se-(zt?at:0);Ce=z(zd(zn,$,W)),ve=(G==0?Ce/2:G==Y?0:Ce)-G*Y*((G==0?N/2:0)+(zt?at/2:0));let Et={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Dn=Xe?null:new Path2D,dn=null;if(he!=null)dn=f.data[he.series[1]];else{let{y0:Pe,y1:Ke}=c;Pe!=null&&Ke!=null&&(E=Ke.values(f,g,y,p),dn=Pe.values(f,g,y,p))}let wn=H*Ce,B=le*Ce;for(let Pe=Y==1?y:p;Pe>=y&&Pe<=p;Pe+=Y){let Ke=E[Pe];if(Ke==null)continue;if(dn!=null){let q=dn[Pe]??0;if(Ke-q==0)continue;me=v(q,R,D,U)}let lt=S.distr!=2||c!=null?x[Pe]:Pe,Me=C(lt,S,I,w),Gt=v(Ct(Ke,ee),R,D,U),We=z(Me-ve),Ze=z(hi(Gt,me)),P=z(Yi(Gt,me)),M=Ze-P;if(Ke!=null){let q=Ke<0?B:wn,ue=Ke<0?wn:B;Xe?(at>0&&rt[Pe]!=null&&j(sn.get(rt[Pe]),We,P+Ti(at/2),Ce,hi(0,M-at),q,ue),pt[Pe]!=null&&j(ht.get(pt[Pe]),We,P+Ti(at/2),Ce,hi(0,M-at),q,ue)):j(Dn,We,P+Ti(at/2),Ce,hi(0,M-at),q,ue),ie(f,g,Pe,We-at/2,P,Ce+at,M)}}return at>0?Et.stroke=Xe?sn:Dn:Xe||(Et._fill=m.width==0?m._fill:m._stroke??m._fill,Et.width=0),Et.fill=Xe?ht:Dn,Et})}function XS(n,e){let t=Ct(e?.alignGaps,0);return(i,s,r,o)=>Ur(i,s,(a,l,c,u,d,h,f,g,y,p,m)=>{[r,o]=xc(c,r,o);let x=a.pxRound,E=H=>x(h(H,u,p,g)),S=H=>x(f(H,d,m,y)),R,C,v;u.ori==0?(R=wc,v=Po,C=L0):(R=Ec,v=Io,C=D0);let w=u.dir*(u.ori==0?1:-1),U=E(l[w==1?r:o]),I=U,D=[],z=[];for(let H=w==1?r:o;H>=r&&H<=o;H+=w)if(c[H]!=null){let Y=l[H],j=E(Y);D.push(I=j),z.push(S(c[H]))}let G={stroke:n(D,z,R,v,C,x),fill:null,clip:null,band:null,gaps:null,flags:Co},N=G.stroke,[W,$]=sf(i,s);if(a.fill!=null||W!=0){let H=G.fill=new Path2D(N),le=a.fillTo(i,s,a.min,a.max,W),Y=S(le);v(H,I,Y),v(H,U,Y)}if(!a.spanGaps){let H=[];H.push(...rf(l,c,r,o,w,E,t)),G.gaps=H=a.gaps(i,s,r,o,H),G.clip=Mc(H,u.ori,g,y,p,m)}return $!=0&&(G.band=$==2?[Ls(i,s,r,o,N,-1),Ls(i,s,r,o,N,1)]:Ls(i,s,r,o,N,$)),G})}function qS(n){return XS(YS,n)}function YS(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),d=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],d[h]=n[h+1]-n[h],c[h]=u[h]/d[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(d[h-1]+d[h])/((2*d[h]+d[h-1])/c[h-1]+(d[h]+2*d[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+d[h]/3,e[h]+l[h]*d[h]/3,n[h+1]-d[h]/3,e[h+1]-l[h+1]*d[h]/3,n[h+1],e[h+1])}return a}var Wd=new Set;function Jg(){for(let n of Wd)n.syncRect(!0)}Ro&&(Nr(Ab,wo,Jg),Nr(Cb,wo,Jg,!0),Nr(gc,wo,()=>{$n.pxRatio=It}));var $S=U0(),ZS=N0();function Qg(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Xd(r,o,e,t))}function KS(n,e){return n.map((t,i)=>i==0?{}:Pn({},e,t))}function Xd(n,e,t,i){return Pn({},e==0?t:i,n)}function O0(n,e,t){return e==null?To:[e,t]}var JS=O0;function QS(n,e,t){return e==null?To:_c(e,t,Kd,!0)}function k0(n,e,t,i){return e==null?To:yc(e,t,n.scales[i].log,!1)}var jS=k0;function B0(n,e,t,i){return e==null?To:Zd(e,t,n.scales[i].log,!1)}var eM=B0;function tM(n,e,t,i,s){let r=hi(Pg(n),Pg(e)),o=e-n,a=qi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?or.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function jg(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Un((t=+s)*It))+"px"),[n,e,t]}function nM(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Xt(e[2]*It,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function $n(n,e,t){let i={mode:Ct(n.mode,1)},s=i.mode;function r(b,T,L,F){let X=T.valToPct(b);return F+L*(T.dir==-1?1-X:X)}function o(b,T,L,F){let X=T.valToPct(b);return F+L*(T.dir==-1?X:1-X)}function a(b,T,L,F){return T.ori==0?r(b,T,L,F):o(b,T,L,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Oi(cb);if(n.id!=null&&(c.id=n.id),Ei(c,n.class),n.title){let b=Oi(db,c);b.textContent=n.title}let u=Xi("canvas"),d=i.ctx=u.getContext("2d"),h=Oi(fb,c);Nr("click",h,b=>{b.target===g&&(Jt!=ao||rn!=lo)&&Yn.click(i,b)},!0);let f=i.under=Oi(pb,h);h.appendChild(u);let g=i.over=Oi(mb,h);n=Ao(n);let y=+Ct(n.pxAlign,1),p=Zg(y);(n.plugins||[]).forEach(b=>{b.opts&&(n=b.opts(i,n)||n)});let m=n.ms||.001,x=i.series=s==1?Qg(n.series||[],Gg,Yg,!1):KS(n.series||[null],qg),E=i.axes=Qg(n.axes||[],Vg,Wg,!0),S=i.scales={},R=i.bands=n.bands||[];R.forEach(b=>{b.fill=bt(b.fill||null),b.dir=Ct(b.dir,-1)});let C=s==2?x[1].facets[0].scale:x[0].scale,v={axes:As,series:_t},w=(n.drawOrder||["axes","series"]).map(b=>v[b]);function U(b){let T=b.distr==3?L=>Is(L>0?L:b.clamp(i,L,b.min,b.max,b.key)):b.distr==4?L=>Ld(L,b.asinh):b.distr==100?L=>b.fwd(L):L=>L;return L=>{let F=T(L),{_min:X,_max:J}=b,ae=J-X;return(F-X)/ae}}function I(b){let T=S[b];if(T==null){let L=(n.scales||Da)[b]||Da;if(L.from!=null){I(L.from);let F=Pn({},S[L.from],L,{key:b});F.valToPct=U(F),S[b]=F}else{T=S[b]=Pn({},b==C?A0:kS,L),T.key=b;let F=T.time,X=T.range,J=rr(X);if((b!=C||s==2&&!F)&&(J&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Ag:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Ag:{mode:1,hard:X[1],soft:X[1]}},J=!1),!J&&Sc(X))){let ae=X;X=(fe,ye,Fe)=>ye==null?To:_c(ye,Fe,ae)}T.range=bt(X||(F?JS:b==C?T.distr==3?jS:T.distr==4?eM:O0:T.distr==3?k0:T.distr==4?B0:QS)),T.auto=bt(J?!1:T.auto),T.clamp=bt(T.clamp||OS),T._min=T._max=null,T.valToPct=U(T)}}}I("x"),I("y"),s==1&&x.forEach(b=>{I(b.scale)}),E.forEach(b=>{I(b.scale)});for(let b in n.scales)I(b);let D=S[C],z=D.distr,G,N;D.ori==0?(Ei(c,ub),G=r,N=o):(Ei(c,hb),G=o,N=r);let W={};for(let b in S){let T=S[b];(T.min!=null||T.max!=null)&&(W[b]={min:T.min,max:T.max},T.min=T.max=null)}let $=n.tzDate||(b=>new Date(Un(b/m))),H=n.fmtDate||jd,le=m==1?uS($):fS($),Y=kg($,Og(m==1?cS:dS,H)),j=zg($,Bg(mS,H)),ie=[],he=i.legend=Pn({},vS,n.legend),de=i.cursor=Pn({},wS,{drag:{y:s==2}},n.cursor),ee=he.show,me=de.show,ve=he.markers;he.idxs=ie,ve.width=bt(ve.width),ve.dash=bt(ve.dash),ve.stroke=bt(ve.stroke),ve.fill=bt(ve.fill);let Ce,Se,Ye,at=[],Xe=[],pt,ht=!1,rt={};if(he.live){let b=x[1]?x[1].values:null;ht=b!=null,pt=ht?b(i,1,0):{_:0};for(let T in pt)rt[T]=Yd}if(ee)if(Ce=Xi("table",bb,c),Ye=Xi("tbody",null,Ce),he.mount(i,Ce),ht){Se=Xi("thead",null,Ce,Ye);let b=Xi("tr",null,Se);Xi("th",null,b);for(var sn in pt)Xi("th",pg,b).textContent=sn}else Ei(Ce,Mb),he.live&&Ei(Ce,Sb);let Yt={show:!0},Mn={show:!1};function zt(b,T){if(T==0&&(ht||!he.live||s==2))return To;let L=[],F=Xi("tr",wb,Ye,Ye.childNodes[T]);Ei(F,b.class),b.show||Ei(F,Dr);let X=Xi("th",null,F);if(ve.show){let fe=Oi(Eb,X);if(T>0){let ye=ve.width(i,T);ye&&(fe.style.border=ye+"px "+ve.dash(i,T)+" "+ve.stroke(i,T)),fe.style.background=ve.fill(i,T)}}let J=Oi(pg,X);b.label instanceof HTMLElement?J.appendChild(b.label):J.textContent=b.label,T>0&&(ve.show||(J.style.color=b.width>0?ve.stroke(i,T):ve.fill(i,T)),Et("click",X,fe=>{if(de._lock)return;je(fe);let ye=x.indexOf(b);if((fe.ctrlKey||fe.metaKey)!=he.isolate){let Fe=x.some((Ue,ke)=>ke>0&&ke!=ye&&Ue.show);x.forEach((Ue,ke)=>{ke>0&&os(ke,Fe?ke==ye?Yt:Mn:Yt,!0,Cn.setSeries)})}else os(ye,{show:!b.show},!0,Cn.setSeries)},!1),et&&Et(vg,X,fe=>{de._lock||(je(fe),os(x.indexOf(b),uo,!0,Cn.setSeries))},!1));for(var ae in pt){let fe=Xi("td",Tb,F);fe.textContent="--",L.push(fe)}return[F,L]}let zn=new Map;function Et(b,T,L,F=!0){let X=zn.get(T)||{},J=de.bind[b](i,T,L,F);J&&(Nr(b,T,X[b]=J),zn.set(T,X))}function Dn(b,T,L){let F=zn.get(T)||{};for(let X in F)(b==null||X==b)&&(Bd(X,T,F[X]),delete F[X]);b==null&&zn.delete(T)}let dn=0,wn=0,B=0,Pe=0,Ke=0,lt=0,Me=Ke,Gt=lt,We=B,Ze=Pe,P=0,M=0,q=0,ue=0;i.bbox={};let oe=!1,_e=!1,xe=!1,te=!1,se=!1,pe=!1;function k(b,T,L){(L||b!=i.width||T!=i.height)&&re(b,T),dt(!1),xe=!0,_e=!0,Jn()}function re(b,T){i.width=dn=B=b,i.height=wn=Pe=T,Ke=lt=0,be(),qe();let L=i.bbox;P=L.left=Ir(Ke*It,.5),M=L.top=Ir(lt*It,.5),q=L.width=Ir(B*It,.5),ue=L.height=Ir(Pe*It,.5)}let ne=3;function we(){let b=!1,T=0;for(;!b;){T++;let L=so(T),F=rs(T);b=T==ne||L&&F,b||(re(i.width,i.height),_e=!0)}}function ge({width:b,height:T}){k(b,T)}i.setSize=ge;function be(){let b=!1,T=!1,L=!1,F=!1;E.forEach((X,J)=>{if(X.show&&X._show){let{side:ae,_size:fe}=X,ye=ae%2,Fe=X.label!=null?X.labelSize:0,Ue=fe+Fe;Ue>0&&(ye?(B-=Ue,ae==3?(Ke+=Ue,F=!0):L=!0):(Pe-=Ue,ae==0?(lt+=Ue,b=!0):T=!0))}}),is[0]=b,is[1]=L,is[2]=T,is[3]=F,B-=Vi[1]+Vi[3],Ke+=Vi[3],Pe-=Vi[2]+Vi[0],lt+=Vi[0]}function qe(){let b=Ke+B,T=lt+Pe,L=Ke,F=lt;function X(J,ae){switch(J){case 1:return b+=ae,b-ae;case 2:return T+=ae,T-ae;case 3:return L-=ae,L+ae;case 0:return F-=ae,F+ae}}E.forEach((J,ae)=>{if(J.show&&J._show){let fe=J.side;J._pos=X(fe,J._size),J.label!=null&&(J._lpos=X(fe,J.labelSize))}})}if(de.dataIdx==null){let b=de.hover,T=b.skip=new Set(b.skip??[]);T.add(void 0);let L=b.prox=bt(b.prox),F=b.bias??=0;de.dataIdx=(X,J,ae,fe)=>{if(J==0)return ae;let ye=ae,Fe=L(X,J,ae,fe)??Wt,Ue=Fe>=0&&Fe<Wt,ke=D.ori==0?B:Pe,ot=de.left,Rt=e[0],At=e[J];if(T.has(At[ae])){ye=null;let vt=null,Qe=null,$e;if(F==0||F==-1)for($e=ae;vt==null&&$e-- >0;)T.has(At[$e])||(vt=$e);if(F==0||F==1)for($e=ae;Qe==null&&$e++<At.length;)T.has(At[$e])||(Qe=$e);if(vt!=null||Qe!=null)if(Ue){let jt=vt==null?-1/0:G(Rt[vt],D,ke,0),mn=Qe==null?1/0:G(Rt[Qe],D,ke,0),Wn=ot-jt,Vt=mn-ot;Wn<=Vt?Wn<=Fe&&(ye=vt):Vt<=Fe&&(ye=Qe)}else ye=Qe==null?vt:vt==null?Qe:ae-vt<=Qe-ae?vt:Qe}else Ue&&On(ot-G(Rt[ae],D,ke,0))>Fe&&(ye=null);return ye}}let je=b=>{de.event=b};de.idxs=ie,de._lock=!1;let ce=de.points;ce.show=bt(ce.show),ce.size=bt(ce.size),ce.stroke=bt(ce.stroke),ce.width=bt(ce.width),ce.fill=bt(ce.fill);let Be=i.focus=Pn({},n.focus||{alpha:.3},de.focus),et=Be.prox>=0,Re=et&&ce.one,ut=[],Kt=[],ri=[];function ua(b,T){let L=ce.show(i,T);if(L instanceof HTMLElement)return Ei(L,yb),Ei(L,b.class),fs(L,-10,-10,B,Pe),g.insertBefore(L,ut[T]),L}function to(b,T){if(s==1||T>0){let L=s==1&&S[b.scale].time,F=b.value;b.value=L?Dg(F)?zg($,Bg(F,H)):F||j:F||NS,b.label=b.label||(L?TS:ES)}if(Re||T>0){b.width=b.width==null?1:b.width,b.paths=b.paths||$S||kb,b.fillTo=bt(b.fillTo||BS),b.pxAlign=+Ct(b.pxAlign,y),b.pxRound=Zg(b.pxAlign),b.stroke=bt(b.stroke||null),b.fill=bt(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let L=FS(hi(1,b.width),1),F=b.points=Pn({},{size:L,width:hi(1,L*.2),stroke:b.stroke,space:L*2,paths:ZS,_stroke:null,_fill:null},b.points);F.show=bt(F.show),F.filter=bt(F.filter),F.fill=bt(F.fill),F.stroke=bt(F.stroke),F.paths=bt(F.paths),F.pxAlign=b.pxAlign}if(ee){let L=zt(b,T);at.splice(T,0,L[0]),Xe.splice(T,0,L[1]),he.values.push(null)}if(me){ie.splice(T,0,null);let L=null;Re?T==0&&(L=ua(b,T)):T>0&&(L=ua(b,T)),ut.splice(T,0,L),Kt.splice(T,0,0),ri.splice(T,0,0)}Hn("addSeries",T)}function Zh(b,T){T=T??x.length,b=s==1?Xd(b,T,Gg,Yg):Xd(b,T,{},qg),x.splice(T,0,b),to(x[T],T)}i.addSeries=Zh;function Cl(b){if(x.splice(b,1),ee){he.values.splice(b,1),Xe.splice(b,1);let T=at.splice(b,1)[0];Dn(null,T.firstChild),T.remove()}me&&(ie.splice(b,1),ut.splice(b,1)[0].remove(),Kt.splice(b,1),ri.splice(b,1)),Hn("delSeries",b)}i.delSeries=Cl;let is=[!1,!1,!1,!1];function ws(b,T){if(b._show=b.show,b.show){let L=b.side%2,F=S[b.scale];F==null&&(b.scale=L?x[1].scale:C,F=S[b.scale]);let X=F.time;b.size=bt(b.size),b.space=bt(b.space),b.rotate=bt(b.rotate),rr(b.incrs)&&b.incrs.forEach(ae=>{!or.has(ae)&&or.set(ae,l0(ae))}),b.incrs=bt(b.incrs||(F.distr==2?oS:X?m==1?lS:hS:Lr)),b.splits=bt(b.splits||(X&&F.distr==1?le:F.distr==3?Vd:F.distr==4?RS:CS)),b.stroke=bt(b.stroke),b.grid.stroke=bt(b.grid.stroke),b.ticks.stroke=bt(b.ticks.stroke),b.border.stroke=bt(b.border.stroke);let J=b.values;b.values=rr(J)&&!rr(J[0])?bt(J):X?rr(J)?kg($,Og(J,H)):Dg(J)?pS($,J):J||Y:J||AS,b.filter=bt(b.filter||(F.distr>=3&&F.log==10?LS:F.distr==3&&F.log==2?DS:o0)),b.font=jg(b.font),b.labelFont=jg(b.labelFont),b._size=b.size(i,null,T,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&(is[T]=!0,b._el=Oi(gb,h))}}function Es(b,T,L,F){let[X,J,ae,fe]=L,ye=T%2,Fe=0;return ye==0&&(fe||J)&&(Fe=T==0&&!X||T==2&&!ae?Un(Vg.size/3):0),ye==1&&(X||ae)&&(Fe=T==1&&!J||T==3&&!fe?Un(Wg.size/2):0),Fe}let ha=i.padding=(n.padding||[Es,Es,Es,Es]).map(b=>bt(Ct(b,Es))),Vi=i._padding=ha.map((b,T)=>b(i,T,is,0)),fn,yn=null,bn=null,ss=s==1?x[0].idxs:null,yi=null,qs=!1;function da(b,T){if(e=b??[],i.data=i._data=e,s==2){fn=0;for(let L=1;L<x.length;L++)fn+=e[L][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),yi=e[0],fn=yi.length;let L=e;if(z==2){L=e.slice();let F=L[0]=Array(fn);for(let X=0;X<fn;X++)F[X]=X}i._data=e=L}if(dt(!0),Hn("setData"),z==2&&(xe=!0),T!==!1){let L=D;L.auto(i,qs)?fa():Zs(C,L.min,L.max),te=te||de.left>=0,pe=!0,Jn()}}i.setData=da;function fa(){qs=!0;let b,T;s==1&&(fn>0?(yn=ss[0]=0,bn=ss[1]=fn-1,b=e[0][yn],T=e[0][bn],z==2?(b=yn,T=bn):b==T&&(z==3?[b,T]=yc(b,b,D.log,!1):z==4?[b,T]=Zd(b,b,D.log,!1):D.time?T=b+Un(86400/m):[b,T]=_c(b,T,Kd,!0))):(yn=ss[0]=b=null,bn=ss[1]=T=null)),Zs(C,b,T)}let no,Ys,io,A,V,Q,Z,K,Ee,Ie;function Te(b,T,L,F,X,J){b??=gg,L??=Qd,F??="butt",X??=gg,J??="round",b!=no&&(d.strokeStyle=no=b),X!=Ys&&(d.fillStyle=Ys=X),T!=io&&(d.lineWidth=io=T),J!=V&&(d.lineJoin=V=J),F!=Q&&(d.lineCap=Q=F),L!=A&&d.setLineDash(A=L)}function De(b,T,L,F){T!=Ys&&(d.fillStyle=Ys=T),b!=Z&&(d.font=Z=b),L!=K&&(d.textAlign=K=L),F!=Ee&&(d.textBaseline=Ee=F)}function Ge(b,T,L,F,X=0){if(F.length>0&&b.auto(i,qs)&&(T==null||T.min==null)){let J=Ct(yn,0),ae=Ct(bn,F.length-1),fe=L.min==null?Lb(F,J,ae,X,b.distr==3):[L.min,L.max];b.min=Yi(b.min,L.min=fe[0]),b.max=hi(b.max,L.max=fe[1])}}let nt={min:null,max:null};function gt(){for(let F in S){let X=S[F];W[F]==null&&(X.min==null||W[C]!=null&&X.auto(i,qs))&&(W[F]=nt)}for(let F in S){let X=S[F];W[F]==null&&X.from!=null&&W[X.from]!=null&&(W[F]=nt)}W[C]!=null&&dt(!0);let b={};for(let F in W){let X=W[F];if(X!=null){let J=b[F]=Ao(S[F],Vb);if(X.min!=null)Pn(J,X);else if(F!=C||s==2)if(fn==0&&J.from==null){let ae=J.range(i,null,null,F);J.min=ae[0],J.max=ae[1]}else J.min=Wt,J.max=-Wt}}if(fn>0){x.forEach((F,X)=>{if(s==1){let J=F.scale,ae=W[J];if(ae==null)return;let fe=b[J];if(X==0){let ye=fe.range(i,fe.min,fe.max,J);fe.min=ye[0],fe.max=ye[1],yn=qi(fe.min,e[0]),bn=qi(fe.max,e[0]),bn-yn>1&&(e[0][yn]<fe.min&&yn++,e[0][bn]>fe.max&&bn--),F.min=yi[yn],F.max=yi[bn]}else F.show&&F.auto&&Ge(fe,ae,F,e[X],F.sorted);F.idxs[0]=yn,F.idxs[1]=bn}else if(X>0&&F.show&&F.auto){let[J,ae]=F.facets,fe=J.scale,ye=ae.scale,[Fe,Ue]=e[X],ke=b[fe],ot=b[ye];ke!=null&&Ge(ke,W[fe],J,Fe,J.sorted),ot!=null&&Ge(ot,W[ye],ae,Ue,ae.sorted),F.min=ae.min,F.max=ae.max}});for(let F in b){let X=b[F],J=W[F];if(X.from==null&&(J==null||J.min==null)){let ae=X.range(i,X.min==Wt?null:X.min,X.max==-Wt?null:X.max,F);X.min=ae[0],X.max=ae[1]}}}for(let F in b){let X=b[F];if(X.from!=null){let J=b[X.from];if(J.min==null)X.min=X.max=null;else{let ae=X.range(i,J.min,J.max,F);X.min=ae[0],X.max=ae[1]}}}let T={},L=!1;for(let F in b){let X=b[F],J=S[F];if(J.min!=X.min||J.max!=X.max){J.min=X.min,J.max=X.max;let ae=J.distr;J._min=ae==3?Is(J.min):ae==4?Ld(J.min,J.asinh):ae==100?J.fwd(J.min):J.min,J._max=ae==3?Is(J.max):ae==4?Ld(J.max,J.asinh):ae==100?J.fwd(J.max):J.max,T[F]=L=!0}}if(L){x.forEach((F,X)=>{s==2?X>0&&T.y&&(F._paths=null):T[F.scale]&&(F._paths=null)});for(let F in T)xe=!0,Hn("setScale",F);me&&de.left>=0&&(te=pe=!0)}for(let F in W)W[F]=null}function ze(b){let T=zd(yn-1,0,fn-1),L=zd(bn+1,0,fn-1);for(;b[T]==null&&T>0;)T--;for(;b[L]==null&&L<fn-1;)L++;return[T,L]}function _t(){if(fn>0){let b=x.some(T=>T._focus)&&Ie!=Be.alpha;b&&(d.globalAlpha=Ie=Be.alpha),x.forEach((T,L)=>{if(L>0&&T.show&&(un(L,!1),un(L,!0),T._paths==null)){let F=Ie;Ie!=T.alpha&&(d.globalAlpha=Ie=T.alpha);let X=s==2?[0,e[L][0].length-1]:ze(e[L]);T._paths=T.paths(i,L,X[0],X[1]),Ie!=F&&(d.globalAlpha=Ie=F)}}),x.forEach((T,L)=>{if(L>0&&T.show){let F=Ie;Ie!=T.alpha&&(d.globalAlpha=Ie=T.alpha),T._paths!=null&&Ft(L,!1);{let X=T._paths!=null?T._paths.gaps:null,J=T.points.show(i,L,yn,bn,X),ae=T.points.filter(i,L,J,X);(J||ae)&&(T.points._paths=T.points.paths(i,L,yn,bn,ae),Ft(L,!0))}Ie!=F&&(d.globalAlpha=Ie=F),Hn("drawSeries",L)}}),b&&(d.globalAlpha=Ie=1)}}function un(b,T){let L=T?x[b].points:x[b];L._stroke=L.stroke(i,b),L._fill=L.fill(i,b)}function Ft(b,T){let L=T?x[b].points:x[b],{stroke:F,fill:X,clip:J,flags:ae,_stroke:fe=L._stroke,_fill:ye=L._fill,_width:Fe=L.width}=L._paths;Fe=Xt(Fe*It,3);let Ue=null,ke=Fe%2/2;T&&ye==null&&(ye=Fe>0?"#fff":fe);let ot=L.pxAlign==1&&ke>0;if(ot&&d.translate(ke,ke),!T){let Rt=P-Fe/2,At=M-Fe/2,vt=q+Fe,Qe=ue+Fe;Ue=new Path2D,Ue.rect(Rt,At,vt,Qe)}T?Oe(fe,Fe,L.dash,L.cap,ye,F,X,ae,J):Ut(b,fe,Fe,L.dash,L.cap,ye,F,X,ae,Ue,J),ot&&d.translate(-ke,-ke)}function Ut(b,T,L,F,X,J,ae,fe,ye,Fe,Ue){let ke=!1;ye!=0&&R.forEach((ot,Rt)=>{if(ot.series[0]==b){let At=x[ot.series[1]],vt=e[ot.series[1]],Qe=(At._paths||Da).band;rr(Qe)&&(Qe=ot.dir==1?Qe[0]:Qe[1]);let $e,jt=null;At.show&&Qe&&Nb(vt,yn,bn)?(jt=ot.fill(i,Rt)||J,$e=At._paths.clip):Qe=null,Oe(T,L,F,X,jt,ae,fe,ye,Fe,Ue,$e,Qe),ke=!0}}),ke||Oe(T,L,F,X,J,ae,fe,ye,Fe,Ue)}let Nn=Co|Hd;function Oe(b,T,L,F,X,J,ae,fe,ye,Fe,Ue,ke){Te(b,T,L,F,X),(ye||Fe||ke)&&(d.save(),ye&&d.clip(ye),Fe&&d.clip(Fe)),ke?(fe&Nn)==Nn?(d.clip(ke),Ue&&d.clip(Ue),yt(X,ae),En(b,J,T)):fe&Hd?(yt(X,ae),d.clip(ke),En(b,J,T)):fe&Co&&(d.save(),d.clip(ke),Ue&&d.clip(Ue),yt(X,ae),d.restore(),En(b,J,T)):(yt(X,ae),En(b,J,T)),(ye||Fe||ke)&&d.restore()}function En(b,T,L){L>0&&(T instanceof Map?T.forEach((F,X)=>{d.strokeStyle=no=X,d.stroke(F)}):T!=null&&b&&d.stroke(T))}function yt(b,T){T instanceof Map?T.forEach((L,F)=>{d.fillStyle=Ys=F,d.fill(L)}):T!=null&&b&&d.fill(T)}function Ts(b,T,L,F){let X=E[b],J;if(F<=0)J=[0,0];else{let ae=X._space=X.space(i,b,T,L,F),fe=X._incrs=X.incrs(i,b,T,L,F,ae);J=tM(T,L,fe,F,ae)}return X._found=J}function Tn(b,T,L,F,X,J,ae,fe,ye,Fe){let Ue=ae%2/2;y==1&&d.translate(Ue,Ue),Te(fe,ae,ye,Fe,fe),d.beginPath();let ke,ot,Rt,At,vt=X+(F==0||F==3?-J:J);L==0?(ot=X,At=vt):(ke=X,Rt=vt);for(let Qe=0;Qe<b.length;Qe++)T[Qe]!=null&&(L==0?ke=Rt=b[Qe]:ot=At=b[Qe],d.moveTo(ke,ot),d.lineTo(Rt,At));d.stroke(),y==1&&d.translate(-Ue,-Ue)}function so(b){let T=!0;return E.forEach((L,F)=>{if(!L.show)return;let X=S[L.scale];if(X.min==null){L._show&&(T=!1,L._show=!1,dt(!1));return}else L._show||(T=!1,L._show=!0,dt(!1));let J=L.side,ae=J%2,{min:fe,max:ye}=X,[Fe,Ue]=Ts(F,fe,ye,ae==0?B:Pe);if(Ue==0)return;let ke=X.distr==2,ot=L._splits=L.splits(i,F,fe,ye,Fe,Ue,ke),Rt=X.distr==2?ot.map($e=>yi[$e]):ot,At=X.distr==2?yi[ot[1]]-yi[ot[0]]:Fe,vt=L._values=L.values(i,L.filter(i,Rt,F,Ue,At),F,Ue,At);L._rotate=J==2?L.rotate(i,vt,F,Ue):0;let Qe=L._size;L._size=ki(L.size(i,vt,F,b)),Qe!=null&&L._size!=Qe&&(T=!1)}),T}function rs(b){let T=!0;return ha.forEach((L,F)=>{let X=L(i,F,is,b);X!=Vi[F]&&(T=!1),Vi[F]=X}),T}function As(){for(let b=0;b<E.length;b++){let T=E[b];if(!T.show||!T._show)continue;let L=T.side,F=L%2,X,J,ae=T.stroke(i,b),fe=L==0||L==3?-1:1,[ye,Fe]=T._found;if(T.label!=null){let li=T.labelGap*fe,Mi=Un((T._lpos+li)*It);De(T.labelFont[0],ae,"center",L==2?"top":mg),d.save(),F==1?(X=J=0,d.translate(Mi,Un(M+ue/2)),d.rotate((L==3?-mc:mc)/2)):(X=Un(P+q/2),J=Mi);let Er=s0(T.label)?T.label(i,b,ye,Fe):T.label;d.fillText(Er,X,J),d.restore()}if(Fe==0)continue;let Ue=S[T.scale],ke=F==0?q:ue,ot=F==0?P:M,Rt=T._splits,At=Ue.distr==2?Rt.map(li=>yi[li]):Rt,vt=Ue.distr==2?yi[Rt[1]]-yi[Rt[0]]:ye,Qe=T.ticks,$e=T.border,jt=Qe.show?Qe.size:0,mn=Un(jt*It),Wn=Un((T.alignTo==2?T._size-jt-T.gap:T.gap)*It),Vt=T._rotate*-mc/180,gn=p(T._pos*It),bi=(mn+Wn)*fe,ai=gn+bi;J=F==0?ai:0,X=F==1?ai:0;let Ni=T.font[0],Gi=T.align==1?So:T.align==2?Rd:Vt>0?So:Vt<0?Rd:F==0?"center":L==3?Rd:So,ls=Vt||F==1?"middle":L==2?"top":mg;De(Ni,ae,Gi,ls);let Si=T.font[1]*T.lineGap,Fi=Rt.map(li=>p(a(li,Ue,ke,ot))),Hi=T._values;for(let li=0;li<Hi.length;li++){let Mi=Hi[li];if(Mi!=null){F==0?X=Fi[li]:J=Fi[li],Mi=""+Mi;let Er=Mi.indexOf(`
`)==-1?[Mi]:Mi.split(/\n/gm);for(let ci=0;ci<Er.length;ci++){let em=Er[ci];Vt?(d.save(),d.translate(X,J+ci*Si),d.rotate(Vt),d.fillText(em,0,0),d.restore()):d.fillText(em,X,J+ci*Si)}}}Qe.show&&Tn(Fi,Qe.filter(i,At,b,Fe,vt),F,L,gn,mn,Xt(Qe.width*It,3),Qe.stroke(i,b),Qe.dash,Qe.cap);let cs=T.grid;cs.show&&Tn(Fi,cs.filter(i,At,b,Fe,vt),F,F==0?2:1,F==0?M:P,F==0?ue:q,Xt(cs.width*It,3),cs.stroke(i,b),cs.dash,cs.cap),$e.show&&Tn([gn],[1],F==0?1:0,F==0?1:2,F==1?M:P,F==1?ue:q,Xt($e.width*It,3),$e.stroke(i,b),$e.dash,$e.cap)}Hn("drawAxes")}function dt(b){x.forEach((T,L)=>{L>0&&(T._paths=null,b&&(s==1?(T.min=null,T.max=null):T.facets.forEach(F=>{F.min=null,F.max=null})))})}let pn=!1,oi=!1,Ot=[];function An(){oi=!1;for(let b=0;b<Ot.length;b++)Hn(...Ot[b]);Ot.length=0}function Jn(){pn||($b(Up),pn=!0)}function Rl(b,T=!1){pn=!0,oi=T,b(i),Up(),T&&Ot.length>0&&queueMicrotask(An)}i.batch=Rl;function Up(){if(oe&&(gt(),oe=!1),xe&&(we(),xe=!1),_e){if(tn(f,So,Ke),tn(f,"top",lt),tn(f,Ra,B),tn(f,Pa,Pe),tn(g,So,Ke),tn(g,"top",lt),tn(g,Ra,B),tn(g,Pa,Pe),tn(h,Ra,dn),tn(h,Pa,wn),u.width=Un(dn*It),u.height=Un(wn*It),E.forEach(({_el:b,_show:T,_size:L,_pos:F,side:X})=>{if(b!=null)if(T){let J=X===3||X===0?L:0,ae=X%2==1;tn(b,ae?"left":"top",F-J),tn(b,ae?"width":"height",L),tn(b,ae?"top":"left",ae?lt:Ke),tn(b,ae?"height":"width",ae?Pe:B),kd(b,Dr)}else Ei(b,Dr)}),no=Ys=io=V=Q=Z=K=Ee=A=null,Ie=1,ga(!0),Ke!=Me||lt!=Gt||B!=We||Pe!=Ze){dt(!1);let b=B/We,T=Pe/Ze;if(me&&!te&&de.left>=0){de.left*=b,de.top*=T,ro&&fs(ro,Un(de.left),0,B,Pe),oo&&fs(oo,0,Un(de.top),B,Pe);for(let L=0;L<ut.length;L++){let F=ut[L];F!=null&&(Kt[L]*=b,ri[L]*=T,fs(F,ki(Kt[L]),ki(ri[L]),B,Pe))}}if(Qt.show&&!se&&Qt.left>=0&&Qt.width>0){Qt.left*=b,Qt.width*=b,Qt.top*=T,Qt.height*=T;for(let L in td)tn(co,L,Qt[L])}Me=Ke,Gt=lt,We=B,Ze=Pe}Hn("setSize"),_e=!1}dn>0&&wn>0&&(d.clearRect(0,0,u.width,u.height),Hn("drawClear"),w.forEach(b=>b()),Hn("draw")),Qt.show&&se&&(Pl(Qt),se=!1),me&&te&&(wr(null,!0,!1),te=!1),he.show&&he.live&&pe&&(jh(),pe=!1),l||(l=!0,i.status=1,Hn("ready")),qs=!1,pn=!1}i.redraw=(b,T)=>{xe=T||!1,b!==!1?Zs(C,D.min,D.max):Jn()};function Kh(b,T){let L=S[b];if(L.from==null){if(fn==0){let F=L.range(i,T.min,T.max,b);T.min=F[0],T.max=F[1]}if(T.min>T.max){let F=T.min;T.min=T.max,T.max=F}if(fn>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;b==C&&L.distr==2&&fn>0&&(T.min=qi(T.min,e[0]),T.max=qi(T.max,e[0]),T.min==T.max&&T.max++),W[b]=T,oe=!0,Jn()}}i.setScale=Kh;let Jh,Qh,ro,oo,Op,kp,ao,lo,Bp,zp,Jt,rn,$s=!1,Yn=de.drag,Vn=Yn.x,Gn=Yn.y;me&&(de.x&&(Jh=Oi(vb,g)),de.y&&(Qh=Oi(xb,g)),D.ori==0?(ro=Jh,oo=Qh):(ro=Qh,oo=Jh),Jt=de.left,rn=de.top);let Qt=i.select=Pn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),co=Qt.show?Oi(_b,Qt.over?g:f):null;function Pl(b,T){if(Qt.show){for(let L in b)Qt[L]=b[L],L in td&&tn(co,L,b[L]);T!==!1&&Hn("setSelect")}}i.setSelect=Pl;function Vx(b){if(x[b].show)ee&&kd(at[b],Dr);else if(ee&&Ei(at[b],Dr),me){let L=Re?ut[0]:ut[b];L!=null&&fs(L,-10,-10,B,Pe)}}function Zs(b,T,L){Kh(b,{min:T,max:L})}function os(b,T,L,F){T.focus!=null&&qx(b),T.show!=null&&x.forEach((X,J)=>{J>0&&(b==J||b==null)&&(X.show=T.show,Vx(J),s==2?(Zs(X.facets[0].scale,null,null),Zs(X.facets[1].scale,null,null)):Zs(X.scale,null,null),Jn())}),L!==!1&&Hn("setSeries",b,T),F&&_a("setSeries",i,b,T)}i.setSeries=os;function Gx(b,T){Pn(R[b],T)}function Hx(b,T){b.fill=bt(b.fill||null),b.dir=Ct(b.dir,-1),T=T??R.length,R.splice(T,0,b)}function Wx(b){b==null?R.length=0:R.splice(b,1)}i.addBand=Hx,i.setBand=Gx,i.delBand=Wx;function Xx(b,T){x[b].alpha=T,me&&ut[b]!=null&&(ut[b].style.opacity=T),ee&&at[b]&&(at[b].style.opacity=T)}let Cs,Ks,Mr,uo={focus:!0};function qx(b){if(b!=Mr){let T=b==null,L=Be.alpha!=1;x.forEach((F,X)=>{if(s==1||X>0){let J=T||X==0||X==b;F._focus=T?null:J,L&&Xx(X,J?1:Be.alpha)}}),Mr=b,L&&Jn()}}ee&&et&&Et(xg,Ce,b=>{de._lock||(je(b),Mr!=null&&os(null,uo,!0,Cn.setSeries))});function as(b,T,L){let F=S[T];L&&(b=b/It-(F.ori==1?lt:Ke));let X=B;F.ori==1&&(X=Pe,b=X-b),F.dir==-1&&(b=X-b);let J=F._min,ae=F._max,fe=b/X,ye=J+(ae-J)*fe,Fe=F.distr;return Fe==3?Eo(10,ye):Fe==4?Ub(ye,F.asinh):Fe==100?F.bwd(ye):ye}function Yx(b,T){let L=as(b,C,T);return qi(L,e[0],yn,bn)}i.valToIdx=b=>qi(b,e[0]),i.posToIdx=Yx,i.posToVal=as,i.valToPos=(b,T,L)=>S[T].ori==0?r(b,S[T],L?q:B,L?P:0):o(b,S[T],L?ue:Pe,L?M:0),i.setCursor=(b,T,L)=>{Jt=b.left,rn=b.top,wr(null,T,L)};function Vp(b,T){tn(co,So,Qt.left=b),tn(co,Ra,Qt.width=T)}function Gp(b,T){tn(co,"top",Qt.top=b),tn(co,Pa,Qt.height=T)}let pa=D.ori==0?Vp:Gp,ma=D.ori==1?Vp:Gp;function $x(){if(ee&&he.live)for(let b=s==2?1:0;b<x.length;b++){if(b==0&&ht)continue;let T=he.values[b],L=0;for(let F in T)Xe[b][L++].firstChild.nodeValue=T[F]}}function jh(b,T){if(b!=null&&(b.idxs?b.idxs.forEach((L,F)=>{ie[F]=L}):zb(b.idx)||ie.fill(b.idx),he.idx=ie[0]),ee&&he.live){for(let L=0;L<x.length;L++)(L>0||s==1&&!ht)&&Zx(L,ie[L]);$x()}pe=!1,T!==!1&&Hn("setLegend")}i.setLegend=jh;function Zx(b,T){let L=x[b],F=b==0&&z==2?yi:e[b],X;ht?X=L.values(i,b,T)??rt:(X=L.value(i,T==null?null:F[T],b,T),X=X==null?rt:{_:X}),he.values[b]=X}function wr(b,T,L){Bp=Jt,zp=rn,[Jt,rn]=de.move(i,Jt,rn),de.left=Jt,de.top=rn,me&&(ro&&fs(ro,Un(Jt),0,B,Pe),oo&&fs(oo,0,Un(rn),B,Pe));let F,X=yn>bn;Cs=Wt,Ks=null;let J=D.ori==0?B:Pe,ae=D.ori==1?B:Pe;if(Jt<0||fn==0||X){F=de.idx=null;for(let fe=0;fe<x.length;fe++){let ye=ut[fe];ye!=null&&fs(ye,-10,-10,B,Pe)}et&&os(null,uo,!0,b==null&&Cn.setSeries),he.live&&(ie.fill(F),pe=!0)}else{let fe,ye,Fe;s==1&&(fe=D.ori==0?Jt:rn,ye=as(fe,C),F=de.idx=qi(ye,e[0],yn,bn),Fe=G(e[0][F],D,J,0));let Ue=-10,ke=-10,ot=0,Rt=0,At=!0,vt="",Qe="";for(let $e=s==2?1:0;$e<x.length;$e++){let jt=x[$e],mn=ie[$e],Wn=mn==null?null:s==1?e[$e][mn]:e[$e][1][mn],Vt=de.dataIdx(i,$e,F,ye),gn=Vt==null?null:s==1?e[$e][Vt]:e[$e][1][Vt];if(pe=pe||gn!=Wn||Vt!=mn,ie[$e]=Vt,$e>0&&jt.show){let bi=Vt==null?-10:Vt==F?Fe:G(s==1?e[0][Vt]:e[$e][0][Vt],D,J,0),ai=gn==null?-10:N(gn,s==1?S[jt.scale]:S[jt.facets[1].scale],ae,0);if(et&&gn!=null){let Ni=D.ori==1?Jt:rn,Gi=On(Be.dist(i,$e,Vt,ai,Ni));if(Gi<Cs){let ls=Be.bias;if(ls!=0){let Si=as(Ni,jt.scale),Fi=gn>=0?1:-1,Hi=Si>=0?1:-1;Hi==Fi&&(Hi==1?ls==1?gn>=Si:gn<=Si:ls==1?gn<=Si:gn>=Si)&&(Cs=Gi,Ks=$e)}else Cs=Gi,Ks=$e}}if(pe||Re){let Ni,Gi;D.ori==0?(Ni=bi,Gi=ai):(Ni=ai,Gi=bi);let ls,Si,Fi,Hi,cs,li,Mi=!0,Er=ce.bbox;if(Er!=null){Mi=!1;let ci=Er(i,$e);Fi=ci.left,Hi=ci.top,ls=ci.width,Si=ci.height}else Fi=Ni,Hi=Gi,ls=Si=ce.size(i,$e);if(li=ce.fill(i,$e),cs=ce.stroke(i,$e),Re)$e==Ks&&Cs<=Be.prox&&(Ue=Fi,ke=Hi,ot=ls,Rt=Si,At=Mi,vt=li,Qe=cs);else{let ci=ut[$e];ci!=null&&(Kt[$e]=Fi,ri[$e]=Hi,Tg(ci,ls,Si,Mi),wg(ci,li,cs),fs(ci,ki(Fi),ki(Hi),B,Pe))}}}}if(Re){let $e=Be.prox,jt=Mr==null?Cs<=$e:Cs>$e||Ks!=Mr;if(pe||jt){let mn=ut[0];mn!=null&&(Kt[0]=Ue,ri[0]=ke,Tg(mn,ot,Rt,At),wg(mn,vt,Qe),fs(mn,ki(Ue),ki(ke),B,Pe))}}}if(Qt.show&&$s)if(b!=null){let[fe,ye]=Cn.scales,[Fe,Ue]=Cn.match,[ke,ot]=b.cursor.sync.scales,Rt=b.cursor.drag;if(Vn=Rt._x,Gn=Rt._y,Vn||Gn){let{left:At,top:vt,width:Qe,height:$e}=b.select,jt=b.scales[ke].ori,mn=b.posToVal,Wn,Vt,gn,bi,ai,Ni=fe!=null&&Fe(fe,ke),Gi=ye!=null&&Ue(ye,ot);Ni&&Vn?(jt==0?(Wn=At,Vt=Qe):(Wn=vt,Vt=$e),gn=S[fe],bi=G(mn(Wn,ke),gn,J,0),ai=G(mn(Wn+Vt,ke),gn,J,0),pa(Yi(bi,ai),On(ai-bi))):pa(0,J),Gi&&Gn?(jt==1?(Wn=At,Vt=Qe):(Wn=vt,Vt=$e),gn=S[ye],bi=N(mn(Wn,ot),gn,ae,0),ai=N(mn(Wn+Vt,ot),gn,ae,0),ma(Yi(bi,ai),On(ai-bi))):ma(0,ae)}else nd()}else{let fe=On(Bp-Op),ye=On(zp-kp);if(D.ori==1){let ot=fe;fe=ye,ye=ot}Vn=Yn.x&&fe>=Yn.dist,Gn=Yn.y&&ye>=Yn.dist;let Fe=Yn.uni;Fe!=null?Vn&&Gn&&(Vn=fe>=Fe,Gn=ye>=Fe,!Vn&&!Gn&&(ye>fe?Gn=!0:Vn=!0)):Yn.x&&Yn.y&&(Vn||Gn)&&(Vn=Gn=!0);let Ue,ke;Vn&&(D.ori==0?(Ue=ao,ke=Jt):(Ue=lo,ke=rn),pa(Yi(Ue,ke),On(ke-Ue)),Gn||ma(0,ae)),Gn&&(D.ori==1?(Ue=ao,ke=Jt):(Ue=lo,ke=rn),ma(Yi(Ue,ke),On(ke-Ue)),Vn||pa(0,J)),!Vn&&!Gn&&(pa(0,0),ma(0,0))}if(Yn._x=Vn,Yn._y=Gn,b==null){if(L){if(jp!=null){let[fe,ye]=Cn.scales;Cn.values[0]=fe!=null?as(D.ori==0?Jt:rn,fe):null,Cn.values[1]=ye!=null?as(D.ori==1?Jt:rn,ye):null}_a(Pd,i,Jt,rn,B,Pe,F)}if(et){let fe=L&&Cn.setSeries,ye=Be.prox;Mr==null?Cs<=ye&&os(Ks,uo,!0,fe):Cs>ye?os(null,uo,!0,fe):Ks!=Mr&&os(Ks,uo,!0,fe)}}pe&&(he.idx=F,jh()),T!==!1&&Hn("setCursor")}let Js=null;Object.defineProperty(i,"rect",{get(){return Js==null&&ga(!1),Js}});function ga(b=!1){b?Js=null:(Js=g.getBoundingClientRect(),Hn("syncRect",Js))}function Hp(b,T,L,F,X,J,ae){de._lock||$s&&b!=null&&b.movementX==0&&b.movementY==0||(ed(b,T,L,F,X,J,ae,!1,b!=null),b!=null?wr(null,!0,!0):wr(T,!0,!1))}function ed(b,T,L,F,X,J,ae,fe,ye){if(Js==null&&ga(!1),je(b),b!=null)L=b.clientX-Js.left,F=b.clientY-Js.top;else{if(L<0||F<0){Jt=-10,rn=-10;return}let[Fe,Ue]=Cn.scales,ke=T.cursor.sync,[ot,Rt]=ke.values,[At,vt]=ke.scales,[Qe,$e]=Cn.match,jt=T.axes[0].side%2==1,mn=D.ori==0?B:Pe,Wn=D.ori==1?B:Pe,Vt=jt?J:X,gn=jt?X:J,bi=jt?F:L,ai=jt?L:F;if(At!=null?L=Qe(Fe,At)?a(ot,S[Fe],mn,0):-10:L=mn*(bi/Vt),vt!=null?F=$e(Ue,vt)?a(Rt,S[Ue],Wn,0):-10:F=Wn*(ai/gn),D.ori==1){let Ni=L;L=F,F=Ni}}ye&&(T==null||T.cursor.event.type==Pd)&&((L<=1||L>=B-1)&&(L=Ir(L,B)),(F<=1||F>=Pe-1)&&(F=Ir(F,Pe))),fe?(Op=L,kp=F,[ao,lo]=de.move(i,L,F)):(Jt=L,rn=F)}let td={width:0,height:0,left:0,top:0};function nd(){Pl(td,!1)}let Wp,Xp,qp,Yp;function $p(b,T,L,F,X,J,ae){$s=!0,Vn=Gn=Yn._x=Yn._y=!1,ed(b,T,L,F,X,J,ae,!0,!1),b!=null&&(Et(Id,Ud,Zp,!1),_a(_g,i,ao,lo,B,Pe,null));let{left:fe,top:ye,width:Fe,height:Ue}=Qt;Wp=fe,Xp=ye,qp=Fe,Yp=Ue}function Zp(b,T,L,F,X,J,ae){$s=Yn._x=Yn._y=!1,ed(b,T,L,F,X,J,ae,!1,!0);let{left:fe,top:ye,width:Fe,height:Ue}=Qt,ke=Fe>0||Ue>0,ot=Wp!=fe||Xp!=ye||qp!=Fe||Yp!=Ue;if(ke&&ot&&Pl(Qt),Yn.setScale&&ke&&ot){let Rt=fe,At=Fe,vt=ye,Qe=Ue;if(D.ori==1&&(Rt=ye,At=Ue,vt=fe,Qe=Fe),Vn&&Zs(C,as(Rt,C),as(Rt+At,C)),Gn)for(let $e in S){let jt=S[$e];$e!=C&&jt.from==null&&jt.min!=Wt&&Zs($e,as(vt+Qe,$e),as(vt,$e))}nd()}else de.lock&&(de._lock=!de._lock,wr(T,!0,b!=null));b!=null&&(Dn(Id,Ud),_a(Id,i,Jt,rn,B,Pe,null))}function Kx(b,T,L,F,X,J,ae){if(de._lock)return;je(b);let fe=$s;if($s){let ye=!0,Fe=!0,Ue=10,ke,ot;D.ori==0?(ke=Vn,ot=Gn):(ke=Gn,ot=Vn),ke&&ot&&(ye=Jt<=Ue||Jt>=B-Ue,Fe=rn<=Ue||rn>=Pe-Ue),ke&&ye&&(Jt=Jt<ao?0:B),ot&&Fe&&(rn=rn<lo?0:Pe),wr(null,!0,!0),$s=!1}Jt=-10,rn=-10,ie.fill(null),wr(null,!0,!0),fe&&($s=fe)}function Kp(b,T,L,F,X,J,ae){de._lock||(je(b),fa(),nd(),b!=null&&_a(yg,i,Jt,rn,B,Pe,null))}function Jp(){E.forEach(nM),k(i.width,i.height,!0)}Nr(gc,wo,Jp);let ho={};ho.mousedown=$p,ho.mousemove=Hp,ho.mouseup=Zp,ho.dblclick=Kp,ho.setSeries=(b,T,L,F)=>{let X=Cn.match[2];L=X(i,T,L),L!=-1&&os(L,F,!0,!1)},me&&(Et(_g,g,$p),Et(Pd,g,Hp),Et(vg,g,b=>{je(b),ga(!1)}),Et(xg,g,Kx),Et(yg,g,Kp),Wd.add(i),i.syncRect=ga);let Il=i.hooks=n.hooks||{};function Hn(b,T,L){oi?Ot.push([b,T,L]):b in Il&&Il[b].forEach(F=>{F.call(null,i,T,L)})}(n.plugins||[]).forEach(b=>{for(let T in b.hooks)Il[T]=(Il[T]||[]).concat(b.hooks[T])});let Qp=(b,T,L)=>L,Cn=Pn({key:null,setSeries:!1,filters:{pub:Ig,sub:Ig},scales:[C,x[1]?x[1].scale:null],match:[Lg,Lg,Qp],values:[null,null]},de.sync);Cn.match.length==2&&Cn.match.push(Qp),de.sync=Cn;let jp=Cn.key,id=C0(jp);function _a(b,T,L,F,X,J,ae){Cn.filters.pub(b,T,L,F,X,J,ae)&&id.pub(b,T,L,F,X,J,ae)}id.sub(i);function Jx(b,T,L,F,X,J,ae){Cn.filters.sub(b,T,L,F,X,J,ae)&&ho[b](null,T,L,F,X,J,ae)}i.pub=Jx;function Qx(){id.unsub(i),Wd.delete(i),zn.clear(),Bd(gc,wo,Jp),c.remove(),Ce?.remove(),Hn("destroy")}i.destroy=Qx;function sd(){Hn("init",n,e),da(e||n.data,!1),W[C]?Kh(C,W[C]):fa(),se=Qt.show&&(Qt.width>0||Qt.height>0),te=pe=!0,k(n.width,n.height)}return x.forEach(to),E.forEach(ws),t?t instanceof HTMLElement?(t.appendChild(c),sd()):t(i,sd):sd(),i}$n.assign=Pn;$n.fmtNum=Jd;$n.rangeNum=_c;$n.rangeLog=yc;$n.rangeAsinh=Zd;$n.orient=Ur;$n.pxRatio=It;$n.join=Yb;$n.fmtDate=jd,$n.tzDate=sS;$n.sync=C0;{$n.addGap=zS,$n.clipGaps=Mc;let n=$n.paths={points:N0};n.linear=U0,n.stepped=HS,n.bars=WS,n.spline=qS}var iM=350;function sM(n){return JSON.stringify({...n,pose:null})}var Ac=class extends Bt{constructor(t){super(new Map);this.studio=t;t.document.subscribe(()=>this.later()),t.connection.subscribe(()=>this.later())}studio;timer=0;running=null;isWanted=!1;want(t){this.isWanted=t,this.later()}later(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>{this.follow()},iM)}async follow(){this.running?.abort();let{studio:t}=this,i=t.document.get().oaks.filter(o=>!o.isHidden&&t.hasDepth(o.state));if(!this.isWanted||t.connection.get()!=="open")return;let s=new AbortController;this.running=s;let r=this.get();[...r.keys()].some(o=>!i.some(a=>a.key===o))&&this.set(new Map([...r].filter(([o])=>i.some(a=>a.key===o))));for(let o of i){let a=sM(o.state);if(this.get().get(o.key)?.key===a)continue;let l=await this.measure(a,o.state,s.signal);if(s.signal.aborted)return;this.set(new Map(this.get()).set(o.key,l))}}async measure(t,i,s){try{return{key:t,curve:await hn.accuracy(i,s),error:null}}catch(r){return{key:t,curve:null,error:r instanceof Error?r.message:String(r)}}}};var rM=13,oM=.85;function z0(){return _(en,{title:"Accuracy over distance",testId:"accuracy",children:_(aM,{})})}function aM(){let{studio:n}=He(),e=Tt(null);e.current??=new Ac(n);let t=e.current;Ht(()=>(t.want(!0),()=>t.want(!1)),[t]);let i=Ae(t),{oaks:s,selected:r}=Ae(n.document),o=Ae(n.display),a=Tt(null),l=Tt(null),c=Tt(null);Ht(()=>{if(a.current)return l.current?.destroy(),l.current=cM(a.current,s,i,i.get(r)?.curve?.bands??[],c),()=>{l.current?.destroy(),l.current=null}},[i,r,s.map(({key:h,state:f})=>h+f.model).join(),o.theme,o.showRight]),Ht(()=>n.probe.subscribe(()=>{c.current=n.probe.get()?.trueM??null,l.current?.redraw(!1)}),[n]);let u=[...i.values()].find(({error:h})=>h!==null)?.error,d=[...i.values()].every(({curve:h})=>h===null);return _(xt,{children:[_("div",{ref:a,class:"plot"}),u&&_("p",{class:"problem",role:"alert",children:u}),d&&!u&&_("p",{class:"hint",children:"Measuring…"}),!d&&_("p",{class:"hint",children:"Median error at a flat target. Shaded: what the maker specifies."})]})}function lM(n){let e=[...new Set(n.flatMap(({distancesM:i})=>i))].sort((i,s)=>i-s),t=n.map(i=>{let s=new Map(i.distancesM.map((r,o)=>[r,i.errorPercent[o]??null]));return e.map(r=>s.has(r)?s.get(r):void 0)});return[e,...t]}function cM(n,e,t,i,s){let r=e.flatMap((g,y)=>{let p=t.get(g.key)?.curve;return p?[{oak:g,index:y,curve:p}]:[]});if(r.length===0)return null;let o=getComputedStyle(document.documentElement),a=Number.parseFloat(o.fontSize),l=g=>o.getPropertyValue(g).trim(),c={stroke:l("--muted"),grid:{stroke:l("--line"),width:1},ticks:{stroke:l("--line"),width:1},font:`${oM*a}px system-ui`,size:2.6*a},u=r.flatMap(({curve:g})=>g.errorPercent.filter(y=>y!==null)),d=Math.max(1,...u.map(Math.abs),...i.map(({percent:g})=>g))*1.1,h=Math.min(0,...u)*1.1,f={width:Math.max(n.clientWidth,120),height:rM*a,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{size:5}},scales:{x:{time:!1},y:{range:[h,d]}},axes:[{...c,values:(g,y)=>y.map(p=>`${p} m`)},{...c,size:3.2*a,values:(g,y)=>y.map(p=>`${Number(p.toFixed(2))} %`)}],series:[{},...r.map(({oak:g,index:y})=>({label:g.state.model,stroke:on(Qn(y)),width:2,points:{show:!1}}))],hooks:{drawClear:[g=>uM(g,i,l("--band"))],draw:[g=>hM(g,s.current)]}};return new $n(f,lM(r.map(({curve:g})=>g)),n)}function uM(n,e,t){let{ctx:i}=n;i.save(),i.beginPath(),i.rect(n.bbox.left,n.bbox.top,n.bbox.width,n.bbox.height),i.clip(),i.fillStyle=t;for(let{fromM:s,toM:r,percent:o}of e){let[a,l]=[n.valToPos(s,"x",!0),n.valToPos(r,"x",!0)],[c,u]=[n.valToPos(o,"y",!0),n.valToPos(-o,"y",!0)];i.fillRect(a,c,l-a,u-c)}i.restore()}function hM(n,e){let{ctx:t,bbox:i}=n,[s=0,r=0]=[n.scales.x?.min??0,n.scales.x?.max??0];if(e===null||e<s||e>r)return;let o=n.valToPos(e,"x",!0);t.save(),t.strokeStyle="#ff2d78",t.lineWidth=devicePixelRatio,t.beginPath(),t.moveTo(o,i.top),t.lineTo(o,i.top+i.height),t.stroke(),t.restore()}function Cc({index:n,model:e,isShort:t}){return _("span",{class:"column-name",children:[_("span",{class:"dot-small",style:{background:on(Qn(Math.max(n,0)))}}),_("span",{class:t?"sr-only":"",children:eg(e)})]})}var Rc=260,Lo=90;function dM({counts:n,fromM:e,toM:t},i,s,r){let o=c=>(c-i)/(s-i)*Rc,a=(t-e)/n.length,l=n.flatMap((c,u)=>{let d=(Lo-c/r*(Lo-4)).toFixed(1);return[`${o(e+u*a).toFixed(1)},${d}`,`${o(e+(u+1)*a).toFixed(1)},${d}`]});return`M${o(e).toFixed(1)},${Lo}L${l.join("L")}L${o(t).toFixed(1)},${Lo}`}function V0(){let{studio:n}=He(),e=Ae(n.frames),{oaks:t}=Ae(n.document),i=t.flatMap((l,c)=>{let u=e.get(l.key)?.header.statistics.histogram,d=u?.counts.reduce((h,f)=>h+f,0)??0;return u&&d?[{oak:l,index:c,histogram:u}]:[]}),s=Math.min(...i.map(({histogram:l})=>l.fromM)),r=Math.max(...i.map(({histogram:l})=>l.toM)),o=Math.max(...i.flatMap(({histogram:l})=>l.counts)),a=(0-s)/(r-s)*Rc;return _(en,{title:"Errors, measured minus true",testId:"histogram",children:i.length===0?_("p",{class:"hint",children:"No pixel has a value."}):_("figure",{class:"chart",children:[_("svg",{viewBox:`0 0 ${Rc} ${Lo}`,preserveAspectRatio:"none",role:"img","aria-label":"Histogram of the errors",children:[a>0&&a<Rc&&_("line",{class:"zero",x1:a,x2:a,y1:0,y2:Lo}),i.map(({oak:l,index:c,histogram:u})=>_("path",{d:dM(u,s,r,o),fill:on(Qn(c)),"fill-opacity":i.length>1?.18:.4,stroke:on(Qn(c)),"vector-effect":"non-scaling-stroke"},l.key))]}),_("figcaption",{children:[_("span",{children:ir(s)}),_("span",{children:ir(r)})]})]})})}function G0(){return _(xt,{children:[_(fM,{}),_(gM,{}),_(_M,{}),_(V0,{}),_(z0,{}),_(vM,{})]})}function fM(){let{studio:n}=He(),e=Ae(n.probe),{reasons:t}=Ae(n.catalog),{oaks:i}=Ae(n.document),s=i.findIndex(({key:a})=>a===e?.oak),r=e?t.find(({code:a})=>a===e.reason):void 0,o=e?.reason===0;return _(en,{title:"Pixel",testId:"readout",children:[!e&&_("p",{class:"hint",children:"Move the mouse over an image."}),e&&_(xt,{children:[_("div",{class:`verdict ${o?"":"missing"}`,children:[_("span",{class:"swatch",style:{background:on(o?Qn(Math.max(s,0)):er(e.reason))}}),_("div",{children:[_("strong",{children:o?`${Ta(e.measuredM)}, ${ir(e.errorM)}`:vn(r?.name??"unknown")}),_("p",{children:o?i[s]?.state.model:r?.documentation})]})]}),_("dl",{class:"facts",children:[_("dt",{children:"Pixel"}),_("dd",{children:[e.pixel[0],", ",e.pixel[1]]}),_("dt",{children:"True depth"}),_("dd",{children:Ta(e.trueM)}),_("dt",{children:"Measured depth"}),_("dd",{children:Ta(e.measuredM)}),_("dt",{children:"Error"}),_("dd",{children:[ir(e.errorM),pM(e.errorM,e.trueM)]}),_("dt",{children:"Disparity"}),_("dd",{children:e.disparityPx===null?"–":`${e.disparityPx.toFixed(2)} px`}),_("dt",{"data-tip":"The distance to the next depth that the sensor can report",children:"Depth step"}),_("dd",{children:Ta(e.stepM===null?null:Math.abs(e.stepM))}),_("dt",{children:"Object"}),_("dd",{class:"path",children:e.object??"–"}),e.occluder&&_(xt,{children:[_("dt",{children:"Hidden by"}),_("dd",{class:"path",children:e.occluder})]})]})]})]})}function pM(n,e){return n===null||!e?"":` (${(100*n/e).toFixed(2)} %)`}var mM=["Left","Top","Right","Bottom"];function gM(){let{studio:n}=He(),e=Ae(n.frames),{oaks:t,region:i}=Ae(n.document),s=t.filter(({key:c})=>e.has(c)),r=i.every((c,u)=>c===tr[u]),o=(c,u,d)=>_("tr",{children:[_("th",{scope:"row","data-tip":u,children:c}),s.map(({key:h})=>_("td",{children:d(h)},h))]}),a=c=>e.get(c)?.header.statistics,l=(c,u)=>n.document.commit("region",d=>{let h=d.region.map((f,g)=>g===c?u/100:f);return h[0]<h[2]&&h[1]<h[3]?{...d,region:h}:d});return _(en,{title:r?"Whole image":"Rectangle",testId:"statistics",actions:!r&&_(Ve,{label:"Whole image",class:"text",onClick:()=>n.document.commit("region",c=>({...c,region:tr}))}),children:[_("div",{class:"scroll-x",children:_("table",{class:"numbers",children:[_("thead",{children:_("tr",{children:[_("td",{}),s.map(({key:c,state:u})=>_("th",{scope:"col","data-tip":u.model,children:_(Cc,{index:t.findIndex(d=>d.key===c),model:u.model,isShort:s.length>2})},c))]})}),_("tbody",{children:[o("Fill rate, %","The share of the pixels that show a surface and have a value",c=>Pr(a(c)?.fillRate)),o("Median error, mm","Measured minus true",c=>sr(a(c)?.medianErrorM,!0)),o("Median |error|, mm","The median of the size of the error",c=>sr(a(c)?.medianAbsoluteErrorM)),o("Median |error|, %","The median of the size of the error, relative to the true depth",c=>a(c)?.medianAbsoluteErrorPercent?.toFixed(2)??"–"),o("95th percentile, mm","95 % of the errors are smaller than this",c=>sr(a(c)?.p95AbsoluteErrorM)),o("Pixels, thousands","Those that show a surface",c=>((a(c)?.pixels??0)/1e3).toFixed(0))]})]})}),r?_("p",{class:"hint",children:"Drag a rectangle on an image to measure a part of it."}):_("div",{class:"quad",children:mM.map((c,u)=>_(Rn,{label:c,value:(i[u]??0)*100,onChange:d=>l(u,d),step:1,digits:1,minimum:0,maximum:100,unit:"%"},c))}),r&&_(Ve,{label:"Rectangle…",class:"text",onClick:()=>n.document.commit("region",c=>({...c,region:[.25,.25,.75,.75]}))})]})}function _M(){let{studio:n}=He(),{reasons:e}=Ae(n.catalog),t=Ae(n.frames),{oaks:i}=Ae(n.document),s=i.flatMap(o=>{let a=t.get(o.key)?.header.statistics.reasons,l=a?.reduce((c,u)=>c+u,0)??0;return a&&l?[{oak:o,shares:a.map(c=>c/l)}]:[]}),r=e.filter(({code:o})=>o!==0&&s.some(({shares:a})=>(a[o]??0)>0));return _(en,{title:"Why pixels have no value",testId:"reasons",children:[r.length===0&&_("p",{class:"hint",children:s.length?"Every pixel has a value.":"–"}),s.map(({oak:o,shares:a})=>_("div",{class:"stack",role:"img","aria-label":`${o.state.model}: ${r.map(({code:l,name:c})=>`${vn(c)} ${yo(a[l])}`).join(", ")}`,children:e.map(({code:l})=>a[l]?_("span",{style:{width:`${(a[l]??0)*100}%`,background:on(er(l))}},l):null)},o.key)),_("table",{class:"numbers",children:_("tbody",{children:r.map(({code:o,name:a,documentation:l})=>_("tr",{children:[_("th",{scope:"row","data-tip":l,children:[_("span",{class:"swatch",style:{background:on(er(o))}}),vn(a),", %"]}),s.map(({oak:c,shares:u})=>_("td",{children:Pr(u[o]??0)},c.key))]},o))})})]})}function vM(){let{studio:n}=He(),e=Ae(n.frames),{oaks:t}=Ae(n.document),i=t.flatMap(({key:s,state:r})=>(e.get(s)?.header.findings??[]).map(o=>({key:s,state:r,finding:o})));return i.length===0?null:_(en,{title:`Remarks (${i.length})`,isOpen:!1,children:_("ul",{class:"findings",children:i.map(({key:s,state:r,finding:o},a)=>_("li",{class:o.level,children:[_("strong",{children:[r.model,", ",o.place]}),": ",o.message,o.remedy&&`; ${o.remedy}`]},`${s}${a}`))})})}var xM=6e3;function H0(){let{studio:n}=He(),e=Ae(n.notices),t=Ae(n.connection);return _("div",{class:"notices",role:"region","aria-label":"Messages","aria-live":"polite",children:[t==="lost"&&_("div",{class:"notice error","data-testid":"lost",children:_("p",{children:"No connection to the server. The page connects again as soon as it runs."})}),e.map(i=>_(yM,{notice:i,onClose:()=>n.dismiss(i.id)},i.id))]})}function yM({notice:n,onClose:e}){let t=n.level==="note"&&n.findings.length===0;return Ht(()=>{if(!t)return;let i=setTimeout(e,xM);return()=>clearTimeout(i)},[]),_("div",{class:`notice ${n.level}`,"data-testid":"notice",children:[_("div",{class:"notice-head",children:[_("p",{children:n.text}),_(Ve,{icon:"close",label:"Close",class:"small",onClick:e})]}),n.findings.length>0&&_("ul",{class:"findings",children:n.findings.map(({level:i,place:s,message:r,remedy:o},a)=>_("li",{class:i,children:[_("strong",{children:s}),": ",r,o&&`; ${o}`]},a))})]})}function W0(){let{studio:n}=He(),e=Ae(n.document),{oaks:t}=e,i=t.length>=wa;return _(en,{title:"OAKs",actions:_(xt,{children:[_(bM,{isDisabled:i}),_(Ve,{icon:"copy",label:"Duplicate the selected OAK",onClick:()=>{let r=Fn(e);r&&n.document.commit("add",o=>bd(o,structuredClone(r.state)))},isDisabled:i,testId:"duplicate"})]}),children:[_("ul",{class:"oaks","data-testid":"oaks",children:t.map((r,o)=>_(SM,{oak:r,index:o,isLast:t.length===1},r.key))}),t.length>1&&_(Wi,{label:"Same pose for all",tip:"Moving one OAK moves all, to compare models at the same place",isOn:e.arePosesLinked,onChange:r=>n.document.commit("link poses",o=>({...o,arePosesLinked:r}))})]})}function X0({models:n,selected:e}){return[...new Set(n.map(i=>i.maker))].map(i=>_("optgroup",{label:i,children:n.filter(s=>s.maker===i).map(({name:s,depthSensors:r})=>{let o=r.length>0;return _("option",{value:s,selected:s===e,disabled:!o,children:o?s:`${s} (no depth)`},s)})},i))}function bM({isDisabled:n}){let{studio:e}=He(),{models:t}=Ae(e.catalog),i=s=>{let r=e.catalog.get(),o=gi(r,s),a=Fn(e.document.get());!o||!a||e.document.commit("add",l=>bd(l,Kl(o,a.state.pose)))};return _("select",{class:"add","aria-label":"Add an OAK at the same pose","data-tip":"Add an OAK at the same pose, to compare models","data-testid":"add-oak",disabled:n,value:"",onChange:s=>{i(s.currentTarget.value),s.currentTarget.value=""},children:[_("option",{value:"",children:"Add…"}),_(X0,{models:t})]})}function SM({oak:n,index:e,isLast:t}){let{studio:i}=He(),s=Ae(i.catalog),{selected:r}=Ae(i.document),o=Ae(i.rejections).get(n.key),a=r===n.key,l=()=>i.document.set({...i.document.get(),selected:n.key}),c=d=>{let h=gi(s,d);h&&i.document.commit("model",f=>nr({...f,selected:n.key},n.key,g=>Jl(g,h)))},u=()=>i.document.commit("hide",d=>({...d,oaks:d.oaks.map(h=>h.key===n.key?{...h,isHidden:!h.isHidden}:h)}));return _("li",{class:`oak ${a?"selected":""}`,children:[_("button",{type:"button",class:"dot","aria-label":`Select OAK ${e+1}, ${n.state.model}`,"aria-pressed":a,onClick:l,children:_("span",{style:{background:on(Qn(e))}})}),_("div",{class:"oak-main",onClick:l,children:[_("select",{"aria-label":`Model of OAK ${e+1}`,"data-testid":"model",value:n.state.model,onChange:d=>c(d.currentTarget.value),children:_(X0,{models:s.models,selected:n.state.model})}),_("span",{class:"detail",children:MM(n,s)}),o&&!a&&_("span",{class:"problem",role:"alert",children:o.error})]}),_(Ve,{icon:n.isHidden?"hidden":"eye",label:n.isHidden?"Show":"Hide",isOn:n.isHidden,onClick:u}),_(Ve,{icon:"close",label:"Remove",isDisabled:t,onClick:()=>i.document.commit("remove",d=>Ym(d,n.key))})]})}function MM(n,e){let t=gi(e,n.state.model),i=_i(e,n.state);return t?i?`${i.kind==="tof"?"ToF":i.baselineM?`${(i.baselineM*1e3).toFixed(0)} mm`:"stereo"} · ${i.hfovDeg.toFixed(0)}° · ${n.state.engine}`:`${t.generation} · no depth sensor`:"The server does not know this model."}var M_=0,Bf=1,w_=2;var cl=1,E_=2,na=3,xs=0,mi=1,ii=2,Yr=0,ia=1,zf=2,Vf=3,Gf=4,T_=5;var $r=100,A_=101,C_=102,R_=103,P_=104,I_=200,L_=201,D_=202,N_=203,Hf=204,Wf=205,F_=206,U_=207,O_=208,k_=209,B_=210,z_=211,V_=212,G_=213,H_=214,au=0,lu=1,cu=2,Yo=3,uu=4,hu=5,du=6,fu=7,Bu=0,W_=1,X_=2,ys=0,Xf=1,qf=2,Yf=3,$f=4,Zf=5,Kf=6,Jf=7;var Qf=300,Zr=301,sa=302,zu=303,Vu=304,pu=1e3,ms=1001,mu=1002,Ln=1003,q_=1004;var ul=1005;var pi=1006,Gu=1007;var Hs=1008;var Kn=1009,jf=1010,ep=1011,yr=1012,Hu=1013,es=1014,ts=1015,ns=1016,Wu=1017,Xu=1018,Kr=1020,tp=35902,np=35899,ip=1021,sp=1022,Di=1023,zs=1026,Ws=1027,rp=1028,ra=1029,br=1030,qu=1031;var Yu=1033,hl=33776,dl=33777,fl=33778,pl=33779,$u=35840,Zu=35841,Ku=35842,Ju=35843,Qu=36196,ju=37492,eh=37496,th=37488,nh=37489,ml=37490,ih=37491,sh=37808,rh=37809,oh=37810,ah=37811,lh=37812,ch=37813,uh=37814,hh=37815,dh=37816,fh=37817,ph=37818,mh=37819,gh=37820,_h=37821,vh=36492,xh=36494,yh=36495,bh=36283,Sh=36284,gl=36285,Mh=36286;var Va=2300,gu=2301,su=2302,Pf=2303,If=2400,Lf=2401,Df=2402;var Y_=3200;var wh=0,$_=1,Xs="",Pi="srgb",Ga="srgb-linear",Ha="linear",Dt="srgb";var ru=7680;var Z_=519,K_=512,J_=513,Q_=514,op=515,j_=516,ev=517,ap=518,lp=519,tv=35044;var _l="300 es",zi=2e3,$o=2001;function wM(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function EM(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Wa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function nv(){let n=Wa("canvas");return n.style.display="block",n}var q0={},Zo=null;function cp(...n){let e="THREE."+n.shift();Zo?Zo("log",e,...n):console.log(e,...n)}function iv(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Je(...n){n=iv(n);let e="THREE."+n.shift();if(Zo)Zo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function tt(...n){n=iv(n);let e="THREE."+n.shift();if(Zo)Zo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function za(...n){let e=n.join(" ");e in q0||(q0[e]=!0,Je(...n))}function sv(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var rv={[au]:au,[cu]:du,[uu]:uu,[Yo]:hu,[lu]:lu,[du]:cu,[fu]:fu,[hu]:Yo},Ji=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},jn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var ou=Math.PI/180,_u=180/Math.PI;function vl(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(jn[n&255]+jn[n>>8&255]+jn[n>>16&255]+jn[n>>24&255]+"-"+jn[e&255]+jn[e>>8&255]+"-"+jn[e>>16&15|64]+jn[e>>24&255]+"-"+jn[t&63|128]+jn[t>>8&255]+"-"+jn[t>>16&255]+jn[t>>24&255]+jn[i&255]+jn[i>>8&255]+jn[i>>16&255]+jn[i>>24&255]).toLowerCase()}function wt(n,e,t){return Math.max(e,Math.min(t,n))}function TM(n,e){return(n%e+e)%e}function af(n,e,t){return(1-t)*n+t*e}function ov(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function up(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function AM(n,e){if(e.constructor===Float32Array)return n;let t=up(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function CM(n,e){if(e.constructor===Float32Array)return n;let t=up(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var ct=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=wt(this.x,e.x,t.x),this.y=wt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=wt(this.x,e,t),this.y=wt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(wt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(wt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},$t=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],d=i[s+3],h=r[o+0],f=r[o+1],g=r[o+2],y=r[o+3];if(d!==y||l!==h||c!==f||u!==g){let p=l*h+c*f+u*g+d*y;p<0&&(h=-h,f=-f,g=-g,y=-y,p=-p);let m=1-a;if(p<.9995){let x=Math.acos(p),E=Math.sin(x);m=Math.sin(m*x)/E,a=Math.sin(a*x)/E,l=l*m+h*a,c=c*m+f*a,u=u*m+g*a,d=d*m+y*a}else{l=l*m+h*a,c=c*m+f*a,u=u*m+g*a,d=d*m+y*a;let x=1/Math.sqrt(l*l+c*c+u*u+d*d);l*=x,c*=x,u*=x,d*=x}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=d}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],d=r[o],h=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+u*d+l*f-c*h,e[t+1]=l*g+u*h+c*d-a*f,e[t+2]=c*g+u*f+a*h-l*d,e[t+3]=u*g-a*d-l*h-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),d=a(r/2),h=l(i/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=h*u*d+c*f*g,this._y=c*f*d-h*u*g,this._z=c*u*g+h*f*d,this._w=c*u*d-h*f*g;break;case"YXZ":this._x=h*u*d+c*f*g,this._y=c*f*d-h*u*g,this._z=c*u*g-h*f*d,this._w=c*u*d+h*f*g;break;case"ZXY":this._x=h*u*d-c*f*g,this._y=c*f*d+h*u*g,this._z=c*u*g+h*f*d,this._w=c*u*d-h*f*g;break;case"ZYX":this._x=h*u*d-c*f*g,this._y=c*f*d+h*u*g,this._z=c*u*g-h*f*d,this._w=c*u*d+h*f*g;break;case"YZX":this._x=h*u*d+c*f*g,this._y=c*f*d+h*u*g,this._z=c*u*g-h*f*d,this._w=c*u*d-h*f*g;break;case"XZY":this._x=h*u*d-c*f*g,this._y=c*f*d-h*u*g,this._z=c*u*g+h*f*d,this._w=c*u*d+h*f*g;break;default:Je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],d=t[10],h=i+a+d;if(h>0){let f=.5/Math.sqrt(h+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>d){let f=2*Math.sqrt(1+i-a-d);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-i-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+d-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(wt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},O=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Y0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Y0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),d=2*(r*i-o*t);return this.x=t+l*c+o*d-a*u,this.y=i+l*u+a*c-r*d,this.z=s+l*d+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=wt(this.x,e.x,t.x),this.y=wt(this.y,e.y,t.y),this.z=wt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=wt(this.x,e,t),this.y=wt(this.y,e,t),this.z=wt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(wt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return lf.copy(this).projectOnVector(e),this.sub(lf)}reflect(e){return this.sub(lf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(wt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},lf=new O,Y0=new $t,it=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],d=i[7],h=i[2],f=i[5],g=i[8],y=s[0],p=s[3],m=s[6],x=s[1],E=s[4],S=s[7],R=s[2],C=s[5],v=s[8];return r[0]=o*y+a*x+l*R,r[3]=o*p+a*E+l*C,r[6]=o*m+a*S+l*v,r[1]=c*y+u*x+d*R,r[4]=c*p+u*E+d*C,r[7]=c*m+u*S+d*v,r[2]=h*y+f*x+g*R,r[5]=h*p+f*E+g*C,r[8]=h*m+f*S+g*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=u*o-a*c,h=a*l-u*r,f=c*r-o*l,g=t*d+i*h+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=d*y,e[1]=(s*c-u*i)*y,e[2]=(a*i-s*o)*y,e[3]=h*y,e[4]=(u*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=f*y,e[7]=(i*l-c*t)*y,e[8]=(o*t-i*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return za("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(cf.makeScale(e,t)),this}rotate(e){return za("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(cf.makeRotation(-e)),this}translate(e,t){return za("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(cf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},cf=new it,$0=new it().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Z0=new it().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function RM(){let n={enabled:!0,workingColorSpace:Ga,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Dt&&(s.r=Bs(s.r),s.g=Bs(s.g),s.b=Bs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Dt&&(s.r=qo(s.r),s.g=qo(s.g),s.b=qo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Xs?Ha:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ga]:{primaries:e,whitePoint:i,transfer:Ha,toXYZ:$0,fromXYZ:Z0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Pi},outputColorSpaceConfig:{drawingBufferColorSpace:Pi}},[Pi]:{primaries:e,whitePoint:i,transfer:Dt,toXYZ:$0,fromXYZ:Z0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Pi}}}),n}var St=RM();function Bs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function qo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Do,vu=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Do===void 0&&(Do=Wa("canvas")),Do.width=e.width,Do.height=e.height;let s=Do.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Do}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Wa("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Bs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Bs(t[i]/255)*255):t[i]=Bs(t[i]);return{data:t,width:e.width,height:e.height}}else return Je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},PM=0,Ko=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:PM++}),this.uuid=vl(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(uf(s[o].image)):r.push(uf(s[o]))}else r=uf(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function uf(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?vu.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Je("Texture: Unable to serialize Texture."),{})}var IM=0,hf=new O,vi=class n extends Ji{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=ms,s=ms,r=pi,o=Hs,a=Di,l=Kn,c=n.DEFAULT_ANISOTROPY,u=Xs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:IM++}),this.uuid=vl(),this.name="",this.source=new Ko(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ct(0,0),this.repeat=new ct(1,1),this.center=new ct(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new it,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(hf).x}get height(){return this.source.getSize(hf).y}get depth(){return this.source.getSize(hf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Qf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case pu:e.x=e.x-Math.floor(e.x);break;case ms:e.x=e.x<0?0:1;break;case mu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case pu:e.y=e.y-Math.floor(e.y);break;case ms:e.y=e.y<0?0:1;break;case mu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};vi.DEFAULT_IMAGE=null;vi.DEFAULT_MAPPING=Qf;vi.DEFAULT_ANISOTROPY=1;var an=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],d=l[8],h=l[1],f=l[5],g=l[9],y=l[2],p=l[6],m=l[10];if(Math.abs(u-h)<.01&&Math.abs(d-y)<.01&&Math.abs(g-p)<.01){if(Math.abs(u+h)<.1&&Math.abs(d+y)<.1&&Math.abs(g+p)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let E=(c+1)/2,S=(f+1)/2,R=(m+1)/2,C=(u+h)/4,v=(d+y)/4,w=(g+p)/4;return E>S&&E>R?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=C/i,r=v/i):S>R?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=C/s,r=w/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=v/r,s=w/r),this.set(i,s,r,t),this}let x=Math.sqrt((p-g)*(p-g)+(d-y)*(d-y)+(h-u)*(h-u));return Math.abs(x)<.001&&(x=1),this.x=(p-g)/x,this.y=(d-y)/x,this.z=(h-u)/x,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=wt(this.x,e.x,t.x),this.y=wt(this.y,e.y,t.y),this.z=wt(this.z,e.z,t.z),this.w=wt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=wt(this.x,e,t),this.y=wt(this.y,e,t),this.z=wt(this.z,e,t),this.w=wt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(wt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},xu=class extends Ji{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:pi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new an(0,0,e,t),this.scissorTest=!1,this.viewport=new an(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new vi({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:pi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Ko(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ii=class extends xu{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Xa=class extends vi{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Ln,this.minFilter=Ln,this.wrapR=ms,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var yu=class extends vi{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Ln,this.minFilter=Ln,this.wrapR=ms,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Mt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,d,h,f,g,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,d,h,f,g,y,p)}set(e,t,i,s,r,o,a,l,c,u,d,h,f,g,y,p){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=d,m[14]=h,m[3]=f,m[7]=g,m[11]=y,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/No.setFromMatrixColumn(e,0).length(),r=1/No.setFromMatrixColumn(e,1).length(),o=1/No.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let h=o*u,f=o*d,g=a*u,y=a*d;t[0]=l*u,t[4]=-l*d,t[8]=c,t[1]=f+g*c,t[5]=h-y*c,t[9]=-a*l,t[2]=y-h*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,f=l*d,g=c*u,y=c*d;t[0]=h+y*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*d,t[5]=o*u,t[9]=-a,t[2]=f*a-g,t[6]=y+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,f=l*d,g=c*u,y=c*d;t[0]=h-y*a,t[4]=-o*d,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*u,t[9]=y-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,f=o*d,g=a*u,y=a*d;t[0]=l*u,t[4]=g*c-f,t[8]=h*c+y,t[1]=l*d,t[5]=y*c+h,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*u,t[4]=y-h*d,t[8]=g*d+f,t[1]=d,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*d+g,t[10]=h-y*d}else if(e.order==="XZY"){let h=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*u,t[4]=-d,t[8]=c*u,t[1]=h*d+y,t[5]=o*u,t[9]=f*d-g,t[2]=g*d-f,t[6]=a*u,t[10]=y*d+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(LM,e,DM)}lookAt(e,t,i){let s=this.elements;return Ci.subVectors(e,t),Ci.lengthSq()===0&&(Ci.z=1),Ci.normalize(),ar.crossVectors(i,Ci),ar.lengthSq()===0&&(Math.abs(i.z)===1?Ci.x+=1e-4:Ci.z+=1e-4,Ci.normalize(),ar.crossVectors(i,Ci)),ar.normalize(),Ic.crossVectors(Ci,ar),s[0]=ar.x,s[4]=Ic.x,s[8]=Ci.x,s[1]=ar.y,s[5]=Ic.y,s[9]=Ci.y,s[2]=ar.z,s[6]=Ic.z,s[10]=Ci.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],d=i[5],h=i[9],f=i[13],g=i[2],y=i[6],p=i[10],m=i[14],x=i[3],E=i[7],S=i[11],R=i[15],C=s[0],v=s[4],w=s[8],U=s[12],I=s[1],D=s[5],z=s[9],G=s[13],N=s[2],W=s[6],$=s[10],H=s[14],le=s[3],Y=s[7],j=s[11],ie=s[15];return r[0]=o*C+a*I+l*N+c*le,r[4]=o*v+a*D+l*W+c*Y,r[8]=o*w+a*z+l*$+c*j,r[12]=o*U+a*G+l*H+c*ie,r[1]=u*C+d*I+h*N+f*le,r[5]=u*v+d*D+h*W+f*Y,r[9]=u*w+d*z+h*$+f*j,r[13]=u*U+d*G+h*H+f*ie,r[2]=g*C+y*I+p*N+m*le,r[6]=g*v+y*D+p*W+m*Y,r[10]=g*w+y*z+p*$+m*j,r[14]=g*U+y*G+p*H+m*ie,r[3]=x*C+E*I+S*N+R*le,r[7]=x*v+E*D+S*W+R*Y,r[11]=x*w+E*z+S*$+R*j,r[15]=x*U+E*G+S*H+R*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],d=e[6],h=e[10],f=e[14],g=e[3],y=e[7],p=e[11],m=e[15],x=l*f-c*h,E=a*f-c*d,S=a*h-l*d,R=o*f-c*u,C=o*h-l*u,v=o*d-a*u;return t*(y*x-p*E+m*S)-i*(g*x-p*R+m*C)+s*(g*E-y*R+m*v)-r*(g*S-y*C+p*v)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=e[9],h=e[10],f=e[11],g=e[12],y=e[13],p=e[14],m=e[15],x=t*a-i*o,E=t*l-s*o,S=t*c-r*o,R=i*l-s*a,C=i*c-r*a,v=s*c-r*l,w=u*y-d*g,U=u*p-h*g,I=u*m-f*g,D=d*p-h*y,z=d*m-f*y,G=h*m-f*p,N=x*G-E*z+S*D+R*I-C*U+v*w;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return e[0]=(a*G-l*z+c*D)*W,e[1]=(s*z-i*G-r*D)*W,e[2]=(y*v-p*C+m*R)*W,e[3]=(h*C-d*v-f*R)*W,e[4]=(l*I-o*G-c*U)*W,e[5]=(t*G-s*I+r*U)*W,e[6]=(p*S-g*v-m*E)*W,e[7]=(u*v-h*S+f*E)*W,e[8]=(o*z-a*I+c*w)*W,e[9]=(i*I-t*z-r*w)*W,e[10]=(g*C-y*S+m*x)*W,e[11]=(d*S-u*C-f*x)*W,e[12]=(a*U-o*D-l*w)*W,e[13]=(t*D-i*U+s*w)*W,e[14]=(y*E-g*R-p*x)*W,e[15]=(u*R-d*E+h*x)*W,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,d=a+a,h=r*c,f=r*u,g=r*d,y=o*u,p=o*d,m=a*d,x=l*c,E=l*u,S=l*d,R=i.x,C=i.y,v=i.z;return s[0]=(1-(y+m))*R,s[1]=(f+S)*R,s[2]=(g-E)*R,s[3]=0,s[4]=(f-S)*C,s[5]=(1-(h+m))*C,s[6]=(p+x)*C,s[7]=0,s[8]=(g+E)*v,s[9]=(p-x)*v,s[10]=(1-(h+y))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=No.set(s[0],s[1],s[2]).length(),a=No.set(s[4],s[5],s[6]).length(),l=No.set(s[8],s[9],s[10]).length();r<0&&(o=-o),$i.copy(this);let c=1/o,u=1/a,d=1/l;return $i.elements[0]*=c,$i.elements[1]*=c,$i.elements[2]*=c,$i.elements[4]*=u,$i.elements[5]*=u,$i.elements[6]*=u,$i.elements[8]*=d,$i.elements[9]*=d,$i.elements[10]*=d,t.setFromRotationMatrix($i),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=zi,l=!1){let c=this.elements,u=2*r/(t-e),d=2*r/(i-s),h=(t+e)/(t-e),f=(i+s)/(i-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===zi)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===$o)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=zi,l=!1){let c=this.elements,u=2/(t-e),d=2/(i-s),h=-(t+e)/(t-e),f=-(i+s)/(i-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===zi)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===$o)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},No=new O,$i=new Mt,LM=new O(0,0,0),DM=new O(1,1,1),ar=new O,Ic=new O,Ci=new O,K0=new Mt,J0=new $t,Qi=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],d=s[2],h=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(wt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-wt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(wt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-wt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(h,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(wt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-wt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return K0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(K0,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return J0.setFromEuler(this),this.setFromQuaternion(J0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Qi.DEFAULT_ORDER="XYZ";var Jo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},NM=0,Q0=new O,Fo=new $t,Ds=new Mt,Lc=new O,Fa=new O,FM=new O,UM=new $t,j0=new O(1,0,0),e_=new O(0,1,0),t_=new O(0,0,1),n_={type:"added"},OM={type:"removed"},Uo={type:"childadded",child:null},df={type:"childremoved",child:null},ln=class n extends Ji{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:NM++}),this.uuid=vl(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new O,t=new Qi,i=new $t,s=new O(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Mt},normalMatrix:{value:new it}}),this.matrix=new Mt,this.matrixWorld=new Mt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Jo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Fo.setFromAxisAngle(e,t),this.quaternion.multiply(Fo),this}rotateOnWorldAxis(e,t){return Fo.setFromAxisAngle(e,t),this.quaternion.premultiply(Fo),this}rotateX(e){return this.rotateOnAxis(j0,e)}rotateY(e){return this.rotateOnAxis(e_,e)}rotateZ(e){return this.rotateOnAxis(t_,e)}translateOnAxis(e,t){return Q0.copy(e).applyQuaternion(this.quaternion),this.position.add(Q0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(j0,e)}translateY(e){return this.translateOnAxis(e_,e)}translateZ(e){return this.translateOnAxis(t_,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ds.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Lc.copy(e):Lc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Fa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ds.lookAt(Fa,Lc,this.up):Ds.lookAt(Lc,Fa,this.up),this.quaternion.setFromRotationMatrix(Ds),s&&(Ds.extractRotation(s.matrixWorld),Fo.setFromRotationMatrix(Ds),this.quaternion.premultiply(Fo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(tt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(n_),Uo.child=e,this.dispatchEvent(Uo),Uo.child=null):tt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(OM),df.child=e,this.dispatchEvent(df),df.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ds.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ds.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ds),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(n_),Uo.child=e,this.dispatchEvent(Uo),Uo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Fa,e,FM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Fa,UM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),d=o(e.shapes),h=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),d.length>0&&(i.shapes=d),h.length>0&&(i.skeletons=h),f.length>0&&(i.animations=f),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ln.DEFAULT_UP=new O(0,1,0);ln.DEFAULT_MATRIX_AUTO_UPDATE=!0;ln.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ti=class extends ln{constructor(){super(),this.isGroup=!0,this.type="Group"}},kM={type:"move"},Qo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ti,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ti,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new O,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new O),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ti,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new O,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new O,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let p=t.getJointPose(y,i),m=this._getHandJoint(c,y);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let u=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],h=u.position.distanceTo(d.position),f=.02,g=.005;c.inputState.pinching&&h>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(kM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new ti;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},av={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},lr={h:0,s:0,l:0},Dc={h:0,s:0,l:0};function ff(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var st=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Pi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=St.workingColorSpace){return this.r=e,this.g=t,this.b=i,St.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=St.workingColorSpace){if(e=TM(e,1),t=wt(t,0,1),i=wt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=ff(o,r,e+1/3),this.g=ff(o,r,e),this.b=ff(o,r,e-1/3)}return St.colorSpaceToWorking(this,s),this}setStyle(e,t=Pi){function i(r){r!==void 0&&parseFloat(r)<1&&Je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Pi){let i=av[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Bs(e.r),this.g=Bs(e.g),this.b=Bs(e.b),this}copyLinearToSRGB(e){return this.r=qo(e.r),this.g=qo(e.g),this.b=qo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Pi){return St.workingToColorSpace(ei.copy(this),e),Math.round(wt(ei.r*255,0,255))*65536+Math.round(wt(ei.g*255,0,255))*256+Math.round(wt(ei.b*255,0,255))}getHexString(e=Pi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(ei.copy(this),t);let i=ei.r,s=ei.g,r=ei.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=u<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(ei.copy(this),t),e.r=ei.r,e.g=ei.g,e.b=ei.b,e}getStyle(e=Pi){St.workingToColorSpace(ei.copy(this),e);let t=ei.r,i=ei.g,s=ei.b;return e!==Pi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(lr),this.setHSL(lr.h+e,lr.s+t,lr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(lr),e.getHSL(Dc);let i=af(lr.h,Dc.h,t),s=af(lr.s,Dc.s,t),r=af(lr.l,Dc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ei=new st;st.NAMES=av;var qa=class extends ln{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Qi,this.environmentIntensity=1,this.environmentRotation=new Qi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Zi=new O,Ns=new O,pf=new O,Fs=new O,Oo=new O,ko=new O,i_=new O,mf=new O,gf=new O,_f=new O,vf=new an,xf=new an,yf=new an,ks=class n{constructor(e=new O,t=new O,i=new O){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Zi.subVectors(e,t),s.cross(Zi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Zi.subVectors(s,t),Ns.subVectors(i,t),pf.subVectors(e,t);let o=Zi.dot(Zi),a=Zi.dot(Ns),l=Zi.dot(pf),c=Ns.dot(Ns),u=Ns.dot(pf),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let h=1/d,f=(c*l-a*u)*h,g=(o*u-a*l)*h;return r.set(1-f-g,g,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Fs)===null?!1:Fs.x>=0&&Fs.y>=0&&Fs.x+Fs.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Fs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Fs.x),l.addScaledVector(o,Fs.y),l.addScaledVector(a,Fs.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return vf.setScalar(0),xf.setScalar(0),yf.setScalar(0),vf.fromBufferAttribute(e,t),xf.fromBufferAttribute(e,i),yf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(vf,r.x),o.addScaledVector(xf,r.y),o.addScaledVector(yf,r.z),o}static isFrontFacing(e,t,i,s){return Zi.subVectors(i,t),Ns.subVectors(e,t),Zi.cross(Ns).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Zi.subVectors(this.c,this.b),Ns.subVectors(this.a,this.b),Zi.cross(Ns).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Oo.subVectors(s,i),ko.subVectors(r,i),mf.subVectors(e,i);let l=Oo.dot(mf),c=ko.dot(mf);if(l<=0&&c<=0)return t.copy(i);gf.subVectors(e,s);let u=Oo.dot(gf),d=ko.dot(gf);if(u>=0&&d<=u)return t.copy(s);let h=l*d-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Oo,o);_f.subVectors(e,r);let f=Oo.dot(_f),g=ko.dot(_f);if(g>=0&&f<=g)return t.copy(r);let y=f*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(i).addScaledVector(ko,a);let p=u*g-f*d;if(p<=0&&d-u>=0&&f-g>=0)return i_.subVectors(r,s),a=(d-u)/(d-u+(f-g)),t.copy(s).addScaledVector(i_,a);let m=1/(p+y+h);return o=y*m,a=h*m,t.copy(i).addScaledVector(Oo,o).addScaledVector(ko,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},gs=class{constructor(e=new O(1/0,1/0,1/0),t=new O(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Ki.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Ki.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Ki.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ki):Ki.fromBufferAttribute(r,o),Ki.applyMatrix4(e.matrixWorld),this.expandByPoint(Ki);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Nc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Nc.copy(i.boundingBox)),Nc.applyMatrix4(e.matrixWorld),this.union(Nc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ki),Ki.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ua),Fc.subVectors(this.max,Ua),Bo.subVectors(e.a,Ua),zo.subVectors(e.b,Ua),Vo.subVectors(e.c,Ua),cr.subVectors(zo,Bo),ur.subVectors(Vo,zo),Or.subVectors(Bo,Vo);let t=[0,-cr.z,cr.y,0,-ur.z,ur.y,0,-Or.z,Or.y,cr.z,0,-cr.x,ur.z,0,-ur.x,Or.z,0,-Or.x,-cr.y,cr.x,0,-ur.y,ur.x,0,-Or.y,Or.x,0];return!bf(t,Bo,zo,Vo,Fc)||(t=[1,0,0,0,1,0,0,0,1],!bf(t,Bo,zo,Vo,Fc))?!1:(Uc.crossVectors(cr,ur),t=[Uc.x,Uc.y,Uc.z],bf(t,Bo,zo,Vo,Fc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ki).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ki).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Us[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Us[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Us[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Us[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Us[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Us[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Us[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Us[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Us),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Us=[new O,new O,new O,new O,new O,new O,new O,new O],Ki=new O,Nc=new gs,Bo=new O,zo=new O,Vo=new O,cr=new O,ur=new O,Or=new O,Ua=new O,Fc=new O,Uc=new O,kr=new O;function bf(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){kr.fromArray(n,r);let a=s.x*Math.abs(kr.x)+s.y*Math.abs(kr.y)+s.z*Math.abs(kr.z),l=e.dot(kr),c=t.dot(kr),u=i.dot(kr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var In=new O,Oc=new ct,BM=0,Zn=class extends Ji{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:BM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=tv,this.updateRanges=[],this.gpuType=ts,this.version=0,this._normalizationScale=e!==void 0?up(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Oc.fromBufferAttribute(this,t),Oc.applyMatrix3(e),this.setXY(t,Oc.x,Oc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)In.fromBufferAttribute(this,t),In.applyMatrix3(e),this.setXYZ(t,In.x,In.y,In.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)In.fromBufferAttribute(this,t),In.applyMatrix4(e),this.setXYZ(t,In.x,In.y,In.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)In.fromBufferAttribute(this,t),In.applyNormalMatrix(e),this.setXYZ(t,In.x,In.y,In.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)In.fromBufferAttribute(this,t),In.transformDirection(e),this.setXYZ(t,In.x,In.y,In.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):AM(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):CM(e,this.array)}};var Ya=class extends Zn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var $a=class extends Zn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var mt=class extends Zn{constructor(e,t,i){super(new Float32Array(e),t,i)}},zM=new gs,Oa=new O,Sf=new O,dr=class{constructor(e=new O,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):zM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Oa.subVectors(e,this.center);let t=Oa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Oa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Sf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Oa.copy(e.center).add(Sf)),this.expandByPoint(Oa.copy(e.center).sub(Sf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},VM=0,Bi=new Mt,Mf=new ln,Go=new O,Ri=new gs,ka=new gs,Xn=new O,Nt=class n extends Ji{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:VM++}),this.uuid=vl(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(wM(e)?$a:Ya)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new it().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Bi.makeRotationFromQuaternion(e),this.applyMatrix4(Bi),this}rotateX(e){return Bi.makeRotationX(e),this.applyMatrix4(Bi),this}rotateY(e){return Bi.makeRotationY(e),this.applyMatrix4(Bi),this}rotateZ(e){return Bi.makeRotationZ(e),this.applyMatrix4(Bi),this}translate(e,t,i){return Bi.makeTranslation(e,t,i),this.applyMatrix4(Bi),this}scale(e,t,i){return Bi.makeScale(e,t,i),this.applyMatrix4(Bi),this}lookAt(e){return Mf.lookAt(e),Mf.updateMatrix(),this.applyMatrix4(Mf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Go).negate(),this.translate(Go.x,Go.y,Go.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new mt(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new gs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new O(-1/0,-1/0,-1/0),new O(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];Ri.setFromBufferAttribute(r),this.morphTargetsRelative?(Xn.addVectors(this.boundingBox.min,Ri.min),this.boundingBox.expandByPoint(Xn),Xn.addVectors(this.boundingBox.max,Ri.max),this.boundingBox.expandByPoint(Xn)):(this.boundingBox.expandByPoint(Ri.min),this.boundingBox.expandByPoint(Ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&tt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new dr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new O,1/0);return}if(e){let i=this.boundingSphere.center;if(Ri.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ka.setFromBufferAttribute(a),this.morphTargetsRelative?(Xn.addVectors(Ri.min,ka.min),Ri.expandByPoint(Xn),Xn.addVectors(Ri.max,ka.max),Ri.expandByPoint(Xn)):(Ri.expandByPoint(ka.min),Ri.expandByPoint(ka.max))}Ri.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Xn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Xn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Xn.fromBufferAttribute(a,c),l&&(Go.fromBufferAttribute(e,c),Xn.add(Go)),s=Math.max(s,i.distanceToSquared(Xn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&tt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){tt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Zn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new O,l[U]=new O;let u=new O,d=new O,h=new O,f=new ct,g=new ct,y=new ct,p=new O,m=new O;function x(U,I,D){c[U]=c[I]=c[D]=1,u.fromBufferAttribute(i,U),d.fromBufferAttribute(i,I),h.fromBufferAttribute(i,D),f.fromBufferAttribute(r,U),g.fromBufferAttribute(r,I),y.fromBufferAttribute(r,D),d.sub(u),h.sub(u),g.sub(f),y.sub(f);let z=1/(g.x*y.y-y.x*g.y);isFinite(z)&&(p.copy(d).multiplyScalar(y.y).addScaledVector(h,-g.y).multiplyScalar(z),m.copy(h).multiplyScalar(g.x).addScaledVector(d,-y.x).multiplyScalar(z),a[U].add(p),a[I].add(p),a[D].add(p),l[U].add(m),l[I].add(m),l[D].add(m))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let U=0,I=E.length;U<I;++U){let D=E[U],z=D.start,G=D.count;for(let N=z,W=z+G;N<W;N+=3)x(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let S=new O,R=new O,C=new O,v=new O;function w(U){C.fromBufferAttribute(s,U),v.copy(C);let I=a[U];S.copy(I),S.sub(C.multiplyScalar(C.dot(I))).normalize(),R.crossVectors(v,I);let z=R.dot(l[U])<0?-1:1;o.setXYZW(U,S.x,S.y,S.z,z)}for(let U=0,I=i.count;U<I;++U)c[U]&&w(U);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Zn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,f=i.count;h<f;h++)i.setXYZ(h,0,0,0);let s=new O,r=new O,o=new O,a=new O,l=new O,c=new O,u=new O,d=new O;if(e)for(let h=0,f=e.count;h<f;h+=3){let g=e.getX(h+0),y=e.getX(h+1),p=e.getX(h+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,p),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,p),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let h=0,f=t.count;h<f;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Xn.fromBufferAttribute(e,t),Xn.normalize(),e.setXYZ(t,Xn.x,Xn.y,Xn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,d=a.normalized,h=new c.constructor(l.length*u),f=0,g=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*u;for(let m=0;m<u;m++)h[g++]=c[f++]}return new Zn(h,u,d)}if(this.index===null)return Je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,d=c.length;u<d;u++){let h=c[u],f=e(h,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let d=0,h=c.length;d<h;d++){let f=c[d];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],d=r[c];for(let h=0,f=d.length;h<f;h++)u.push(d[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var wf=new O,GM=new O,HM=new it,di=class{constructor(e=new O(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=wf.subVectors(i,t).cross(GM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(wf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||HM.getNormalMatrix(e),s=this.coplanarPoint(wf).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},WM=0,_s=class extends Ji{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:WM++}),this.uuid=vl(),this.name="",this.type="Material",this.blending=ia,this.side=xs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Hf,this.blendDst=Wf,this.blendEquation=$r,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new st(0,0,0),this.blendAlpha=0,this.depthFunc=Yo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Z_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ru,this.stencilZFail=ru,this.stencilZPass=ru,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new st().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new di().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new ct().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ct().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Os=new O,Ef=new O,kc=new O,Bc=new O,Vr=class{constructor(e=new O,t=new O(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Os)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Os.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Os.copy(this.origin).addScaledVector(this.direction,t),Os.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Ef.copy(e).add(t).multiplyScalar(.5),kc.copy(t).sub(e).normalize(),Bc.copy(this.origin).sub(Ef);let r=e.distanceTo(t)*.5,o=-this.direction.dot(kc),a=Bc.dot(this.direction),l=-Bc.dot(kc),c=Bc.lengthSq(),u=Math.abs(1-o*o),d,h,f,g;if(u>0)if(d=o*l-a,h=o*a-l,g=r*u,d>=0)if(h>=-g)if(h<=g){let y=1/u;d*=y,h*=y,f=d*(d+o*h+2*a)+h*(o*d+h+2*l)+c}else h=r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h=-r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h<=-g?(d=Math.max(0,-(-o*r+a)),h=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c):h<=g?(d=0,h=Math.min(Math.max(-r,-l),r),f=h*(h+2*l)+c):(d=Math.max(0,-(o*r+a)),h=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c);else h=o>0?-r:r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Ef).addScaledVector(kc,h),f}intersectSphere(e,t){if(e.radius<0)return null;Os.subVectors(e.center,this.origin);let i=Os.dot(this.direction),s=Os.dot(Os)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-h.z)*d,l=(e.max.z-h.z)*d):(a=(e.max.z-h.z)*d,l=(e.min.z-h.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Os)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,d=e.x-o.x,h=e.y-o.y,f=e.z-o.z,g=t.x-o.x,y=t.y-o.y,p=t.z-o.z,m=i.x-o.x,x=i.y-o.y,E=i.z-o.z,S=Math.abs(l),R=Math.abs(c),C=Math.abs(u),v,w,U,I,D,z,G,N,W,$,H,le;if(S>=R&&S>=C?(U=l,z=d,W=g,le=m,l>=0?(v=c,w=u,I=h,D=f,G=y,N=p,$=x,H=E):(v=u,w=c,I=f,D=h,G=p,N=y,$=E,H=x)):R>=C?(U=c,z=h,W=y,le=x,c>=0?(v=u,w=l,I=f,D=d,G=p,N=g,$=E,H=m):(v=l,w=u,I=d,D=f,G=g,N=p,$=m,H=E)):(U=u,z=f,W=p,le=E,u>=0?(v=l,w=c,I=d,D=h,G=g,N=y,$=m,H=x):(v=c,w=l,I=h,D=d,G=y,N=g,$=x,H=m)),U===0)return null;let Y=v/U,j=w/U,ie=1/U,he=I-Y*z,de=D-j*z,ee=G-Y*W,me=N-j*W,ve=$-Y*le,Ce=H-j*le,Se=ve*me-Ce*ee,Ye=he*Ce-de*ve,at=ee*de-me*he;if(s){if(Se<0||Ye<0||at<0)return null}else if((Se<0||Ye<0||at<0)&&(Se>0||Ye>0||at>0))return null;let Xe=Se+Ye+at;if(Xe===0)return null;let pt=ie*(Se*z+Ye*W+at*le);return(Xe>0?pt<0:pt>0)?null:this.at(pt/Xe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ji=class extends _s{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new st(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Qi,this.combine=Bu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},s_=new Mt,Br=new Vr,zc=new dr,r_=new O,Vc=new O,Gc=new O,Hc=new O,Tf=new O,Wc=new O,o_=new O,Xc=new O,Le=class extends ln{constructor(e=new Nt,t=new ji){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Wc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],d=r[l];u!==0&&(Tf.fromBufferAttribute(d,e),o?Wc.addScaledVector(Tf,u):Wc.addScaledVector(Tf.sub(t),u))}t.add(Wc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),zc.copy(i.boundingSphere),zc.applyMatrix4(r),Br.copy(e.ray).recast(e.near),!(zc.containsPoint(Br.origin)===!1&&(Br.intersectSphere(zc,r_)===null||Br.origin.distanceToSquared(r_)>(e.far-e.near)**2))&&(s_.copy(r).invert(),Br.copy(e.ray).applyMatrix4(s_),!(i.boundingBox!==null&&Br.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Br)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,h=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=h.length;g<y;g++){let p=h[g],m=o[p.materialIndex],x=Math.max(p.start,f.start),E=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let S=x,R=E;S<R;S+=3){let C=a.getX(S),v=a.getX(S+1),w=a.getX(S+2);s=qc(this,m,e,i,c,u,d,C,v,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let x=a.getX(p),E=a.getX(p+1),S=a.getX(p+2);s=qc(this,o,e,i,c,u,d,x,E,S),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=h.length;g<y;g++){let p=h[g],m=o[p.materialIndex],x=Math.max(p.start,f.start),E=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let S=x,R=E;S<R;S+=3){let C=S,v=S+1,w=S+2;s=qc(this,m,e,i,c,u,d,C,v,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let x=p,E=p+1,S=p+2;s=qc(this,o,e,i,c,u,d,x,E,S),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function XM(n,e,t,i,s,r,o,a){let l;if(e.side===mi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===xs,a),l===null)return null;Xc.copy(a),Xc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Xc);return c<t.near||c>t.far?null:{distance:c,point:Xc.clone(),object:n}}function qc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Vc),n.getVertexPosition(l,Gc),n.getVertexPosition(c,Hc);let u=XM(n,e,t,i,Vc,Gc,Hc,o_);if(u){let d=new O;ks.getBarycoord(o_,Vc,Gc,Hc,d),s&&(u.uv=ks.getInterpolatedAttribute(s,a,l,c,d,new ct)),r&&(u.uv1=ks.getInterpolatedAttribute(r,a,l,c,d,new ct)),o&&(u.normal=ks.getInterpolatedAttribute(o,a,l,c,d,new O),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new O,materialIndex:0};ks.getNormal(Vc,Gc,Hc,h.normal),u.face=h,u.barycoord=d}return u}var Gr=class extends vi{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Ln,u=Ln,d,h){super(null,o,a,l,c,u,s,r,d,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var zr=new dr,qM=new ct(.5,.5),Yc=new O,fr=class{constructor(e=new di,t=new di,i=new di,s=new di,r=new di,o=new di){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=zi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],d=r[5],h=r[6],f=r[7],g=r[8],y=r[9],p=r[10],m=r[11],x=r[12],E=r[13],S=r[14],R=r[15];if(s[0].setComponents(c-o,f-u,m-g,R-x).normalize(),s[1].setComponents(c+o,f+u,m+g,R+x).normalize(),s[2].setComponents(c+a,f+d,m+y,R+E).normalize(),s[3].setComponents(c-a,f-d,m-y,R-E).normalize(),i)s[4].setComponents(l,h,p,S).normalize(),s[5].setComponents(c-l,f-h,m-p,R-S).normalize();else if(s[4].setComponents(c-l,f-h,m-p,R-S).normalize(),t===zi)s[5].setComponents(c+l,f+h,m+p,R+S).normalize();else if(t===$o)s[5].setComponents(l,h,p,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),zr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),zr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(zr)}intersectsSprite(e){zr.center.set(0,0,0);let t=qM.distanceTo(e.center);return zr.radius=.7071067811865476+t,zr.applyMatrix4(e.matrixWorld),this.intersectsSphere(zr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Yc.x=s.normal.x>0?e.max.x:e.min.x,Yc.y=s.normal.y>0?e.max.y:e.min.y,Yc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Yc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},a_=new Mt,bu=class n{constructor(){this.coordinateSystem=zi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];a_.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new fr),i[s].setFromProjectionMatrix(a_,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new fr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var xi=class extends _s{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new st(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Su=new O,Mu=new O,l_=new Mt,Ba=new Vr,$c=new dr,Af=new O,c_=new O,ni=class extends ln{constructor(e=new Nt,t=new xi){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Su.fromBufferAttribute(t,s-1),Mu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Su.distanceTo(Mu);e.setAttribute("lineDistance",new mt(i,1))}else Je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),$c.copy(i.boundingSphere),$c.applyMatrix4(s),$c.radius+=r,e.ray.intersectsSphere($c)===!1)return;l_.copy(s).invert(),Ba.copy(e.ray).applyMatrix4(l_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=c){let m=u.getX(y),x=u.getX(y+1),E=Zc(this,e,Ba,l,m,x,y);E&&t.push(E)}if(this.isLineLoop){let y=u.getX(g-1),p=u.getX(f),m=Zc(this,e,Ba,l,y,p,g-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=c){let m=Zc(this,e,Ba,l,y,y+1,y);m&&t.push(m)}if(this.isLineLoop){let y=Zc(this,e,Ba,l,g-1,f,g-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Zc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Su.fromBufferAttribute(a,s),Mu.fromBufferAttribute(a,r),t.distanceSqToSegment(Su,Mu,Af,c_)>i)return;Af.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Af);if(!(c<e.near||c>e.far))return{distance:c,point:c_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var u_=new O,h_=new O,pr=class extends ni{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)u_.fromBufferAttribute(t,s),h_.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+u_.distanceTo(h_);e.setAttribute("lineDistance",new mt(i,1))}else Je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},Za=class extends ni{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}},jo=class extends _s{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new st(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},d_=new Mt,Nf=new Vr,Kc=new dr,Jc=new O,Hr=class extends ln{constructor(e=new Nt,t=new jo){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Kc.copy(i.boundingSphere),Kc.applyMatrix4(s),Kc.radius+=r,e.ray.intersectsSphere(Kc)===!1)return;d_.copy(s).invert(),Nf.copy(e.ray).applyMatrix4(d_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,d=i.attributes.position;if(c!==null){let h=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let g=h,y=f;g<y;g++){let p=c.getX(g);Jc.fromBufferAttribute(d,p),f_(Jc,p,l,s,e,t,this)}}else{let h=Math.max(0,o.start),f=Math.min(d.count,o.start+o.count);for(let g=h,y=f;g<y;g++)Jc.fromBufferAttribute(d,g),f_(Jc,g,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function f_(n,e,t,i,s,r,o){let a=Nf.distanceSqToPoint(n);if(a<t){let l=new O;Nf.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Ka=class extends vi{constructor(e=[],t=Zr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Vs=class extends vi{constructor(e,t,i=es,s,r,o,a=Ln,l=Ln,c,u=zs,d=1){if(u!==zs&&u!==Ws)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:d};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Ko(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ja=class extends Vs{constructor(e,t=es,i=Zr,s,r,o=Ln,a=Ln,l,c=zs){let u={width:e,height:e,depth:1},d=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Qa=class extends vi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Zt=class n extends Nt{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],d=[],h=0,f=0;g("z","y","x",-1,-1,i,t,e,o,r,0),g("z","y","x",1,-1,i,t,-e,o,r,1),g("x","z","y",1,1,e,i,t,s,o,2),g("x","z","y",1,-1,e,i,-t,s,o,3),g("x","y","z",1,-1,e,t,i,s,r,4),g("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new mt(c,3)),this.setAttribute("normal",new mt(u,3)),this.setAttribute("uv",new mt(d,2));function g(y,p,m,x,E,S,R,C,v,w,U){let I=S/v,D=R/w,z=S/2,G=R/2,N=C/2,W=v+1,$=w+1,H=0,le=0,Y=new O;for(let j=0;j<$;j++){let ie=j*D-G;for(let he=0;he<W;he++){let de=he*I-z;Y[y]=de*x,Y[p]=ie*E,Y[m]=N,c.push(Y.x,Y.y,Y.z),Y[y]=0,Y[p]=0,Y[m]=C>0?1:-1,u.push(Y.x,Y.y,Y.z),d.push(he/v),d.push(1-j/w),H+=1}}for(let j=0;j<w;j++)for(let ie=0;ie<v;ie++){let he=h+ie+W*j,de=h+ie+W*(j+1),ee=h+(ie+1)+W*(j+1),me=h+(ie+1)+W*j;l.push(he,de,me),l.push(de,ee,me),le+=6}a.addGroup(f,le,U),f+=le,h+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var qn=class n extends Nt{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],d=[],h=[],f=[],g=0,y=[],p=i/2,m=0;x(),o===!1&&(e>0&&E(!0),t>0&&E(!1)),this.setIndex(u),this.setAttribute("position",new mt(d,3)),this.setAttribute("normal",new mt(h,3)),this.setAttribute("uv",new mt(f,2));function x(){let S=new O,R=new O,C=0,v=(t-e)/i;for(let w=0;w<=r;w++){let U=[],I=w/r,D=I*(t-e)+e;for(let z=0;z<=s;z++){let G=z/s,N=G*l+a,W=Math.sin(N),$=Math.cos(N);R.x=D*W,R.y=-I*i+p,R.z=D*$,d.push(R.x,R.y,R.z),S.set(W,v,$).normalize(),h.push(S.x,S.y,S.z),f.push(G,1-I),U.push(g++)}y.push(U)}for(let w=0;w<s;w++)for(let U=0;U<r;U++){let I=y[U][w],D=y[U+1][w],z=y[U+1][w+1],G=y[U][w+1];(e>0||U!==0)&&(u.push(I,D,G),C+=3),(t>0||U!==r-1)&&(u.push(D,z,G),C+=3)}c.addGroup(m,C,0),m+=C}function E(S){let R=g,C=new ct,v=new O,w=0,U=S===!0?e:t,I=S===!0?1:-1;for(let z=1;z<=s;z++)d.push(0,p*I,0),h.push(0,I,0),f.push(.5,.5),g++;let D=g;for(let z=0;z<=s;z++){let N=z/s*l+a,W=Math.cos(N),$=Math.sin(N);v.x=U*$,v.y=p*I,v.z=U*W,d.push(v.x,v.y,v.z),h.push(0,I,0),C.x=W*.5+.5,C.y=$*.5*I+.5,f.push(C.x,C.y),g++}for(let z=0;z<s;z++){let G=R+z,N=D+z;S===!0?u.push(N,N+1,G):u.push(N+1,N,G),w+=3}c.addGroup(m,w,S===!0?1:2),m+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var wu=class n extends Nt{constructor(e=[],t=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new mt(r,3)),this.setAttribute("normal",new mt(r.slice(),3)),this.setAttribute("uv",new mt(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let E=new O,S=new O,R=new O;for(let C=0;C<t.length;C+=3)f(t[C+0],E),f(t[C+1],S),f(t[C+2],R),l(E,S,R,x)}function l(x,E,S,R){let C=R+1,v=[];for(let w=0;w<=C;w++){v[w]=[];let U=x.clone().lerp(S,w/C),I=E.clone().lerp(S,w/C),D=C-w;for(let z=0;z<=D;z++)z===0&&w===C?v[w][z]=U:v[w][z]=U.clone().lerp(I,z/D)}for(let w=0;w<C;w++)for(let U=0;U<2*(C-w)-1;U++){let I=Math.floor(U/2);U%2===0?(h(v[w][I+1]),h(v[w+1][I]),h(v[w][I])):(h(v[w][I+1]),h(v[w+1][I+1]),h(v[w+1][I]))}}function c(x){let E=new O;for(let S=0;S<r.length;S+=3)E.x=r[S+0],E.y=r[S+1],E.z=r[S+2],E.normalize().multiplyScalar(x),r[S+0]=E.x,r[S+1]=E.y,r[S+2]=E.z}function u(){let x=new O;for(let E=0;E<r.length;E+=3){x.x=r[E+0],x.y=r[E+1],x.z=r[E+2];let S=p(x)/2/Math.PI+.5,R=m(x)/Math.PI+.5;o.push(S,1-R)}g(),d()}function d(){for(let x=0;x<o.length;x+=6){let E=o[x+0],S=o[x+2],R=o[x+4],C=Math.max(E,S,R),v=Math.min(E,S,R);C>.9&&v<.1&&(E<.2&&(o[x+0]+=1),S<.2&&(o[x+2]+=1),R<.2&&(o[x+4]+=1))}}function h(x){r.push(x.x,x.y,x.z)}function f(x,E){let S=x*3;E.x=e[S+0],E.y=e[S+1],E.z=e[S+2]}function g(){let x=new O,E=new O,S=new O,R=new O,C=new ct,v=new ct,w=new ct;for(let U=0,I=0;U<r.length;U+=9,I+=6){x.set(r[U+0],r[U+1],r[U+2]),E.set(r[U+3],r[U+4],r[U+5]),S.set(r[U+6],r[U+7],r[U+8]),C.set(o[I+0],o[I+1]),v.set(o[I+2],o[I+3]),w.set(o[I+4],o[I+5]),R.copy(x).add(E).add(S).divideScalar(3);let D=p(R);y(C,I+0,x,D),y(v,I+2,E,D),y(w,I+4,S,D)}}function y(x,E,S,R){R<0&&x.x===1&&(o[E]=x.x-1),S.x===0&&S.z===0&&(o[E]=R/2/Math.PI+.5)}function p(x){return Math.atan2(x.z,-x.x)}function m(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.vertices,e.indices,e.radius,e.detail)}};var Qc=new O,jc=new O,Cf=new O,eu=new ks,ja=class extends Nt{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(ou*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],d=new Array(3),h=new Map,f=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:y,b:p,c:m}=eu;if(y.fromBufferAttribute(a,c[0]),p.fromBufferAttribute(a,c[1]),m.fromBufferAttribute(a,c[2]),eu.getNormal(Cf),d[0]=`${Math.round(y.x*s)},${Math.round(y.y*s)},${Math.round(y.z*s)}`,d[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,d[2]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,!(d[0]===d[1]||d[1]===d[2]||d[2]===d[0]))for(let x=0;x<3;x++){let E=(x+1)%3,S=d[x],R=d[E],C=eu[u[x]],v=eu[u[E]],w=`${S}_${R}`,U=`${R}_${S}`,I=h.get(U);I?(Cf.dot(I.normal)<=r&&(f.push(C.x,C.y,C.z),f.push(v.x,v.y,v.z)),h.set(U,null)):h.has(w)||h.set(w,{index0:c[x],index1:c[E],normal:Cf.clone()})}}for(let g of h.values())if(g){let{index0:y,index1:p}=g;Qc.fromBufferAttribute(a,y),jc.fromBufferAttribute(a,p),f.push(Qc.x,Qc.y,Qc.z),f.push(jc.x,jc.y,jc.z)}this.setAttribute("position",new mt(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var mr=class n extends wu{constructor(e=1,t=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new n(e.radius,e.detail)}},Wr=class n extends Nt{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,d=e/a,h=t/l,f=[],g=[],y=[],p=[];for(let m=0;m<u;m++){let x=m*h-o;for(let E=0;E<c;E++){let S=E*d-r;g.push(S,-x,0),y.push(0,0,1),p.push(E/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let x=0;x<a;x++){let E=x+c*m,S=x+c*(m+1),R=x+1+c*(m+1),C=x+1+c*m;f.push(E,S,C),f.push(S,R,C)}this.setIndex(f),this.setAttribute("position",new mt(g,3)),this.setAttribute("normal",new mt(y,3)),this.setAttribute("uv",new mt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Xr=class n extends Nt{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],d=new O,h=new O,f=[],g=[],y=[],p=[];for(let m=0;m<=i;m++){let x=[],E=m/i,S=o+E*a,R=e*Math.cos(S),C=Math.sqrt(e*e-R*R),v=0;m===0&&o===0?v=.5/t:m===i&&l===Math.PI&&(v=-.5/t);for(let w=0;w<=t;w++){let U=w/t,I=s+U*r;d.x=-C*Math.cos(I),d.y=R,d.z=C*Math.sin(I),g.push(d.x,d.y,d.z),h.copy(d).normalize(),y.push(h.x,h.y,h.z),p.push(U+v,1-E),x.push(c++)}u.push(x)}for(let m=0;m<i;m++)for(let x=0;x<t;x++){let E=u[m][x+1],S=u[m][x],R=u[m+1][x],C=u[m+1][x+1];(m!==0||o>0)&&f.push(E,S,C),(m!==i-1||l<Math.PI)&&f.push(S,R,C)}this.setIndex(f),this.setAttribute("position",new mt(g,3)),this.setAttribute("normal",new mt(y,3)),this.setAttribute("uv",new mt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Gs=class n extends Nt{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],d=[],h=new O,f=new O,g=new O;for(let y=0;y<=i;y++){let p=o+y/i*a;for(let m=0;m<=s;m++){let x=m/s*r;f.x=(e+t*Math.cos(p))*Math.cos(x),f.y=(e+t*Math.cos(p))*Math.sin(x),f.z=t*Math.sin(p),c.push(f.x,f.y,f.z),h.x=e*Math.cos(x),h.y=e*Math.sin(x),g.subVectors(f,h).normalize(),u.push(g.x,g.y,g.z),d.push(m/s),d.push(y/i)}}for(let y=1;y<=i;y++)for(let p=1;p<=s;p++){let m=(s+1)*y+p-1,x=(s+1)*(y-1)+p-1,E=(s+1)*(y-1)+p,S=(s+1)*y+p;l.push(m,x,S),l.push(x,E,S)}this.setIndex(l),this.setAttribute("position",new mt(c,3)),this.setAttribute("normal",new mt(u,3)),this.setAttribute("uv",new mt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};function Jr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(p_(s))s.isRenderTargetTexture?(Je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(p_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function si(n){let e={};for(let t=0;t<n.length;t++){let i=Jr(n[t]);for(let s in i)e[s]=i[s]}return e}function p_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function YM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function hp(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var lv={clone:Jr,merge:si},$M=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,ZM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,vs=class extends _s{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=$M,this.fragmentShader=ZM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Jr(e.uniforms),this.uniformsGroups=YM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new st().setHex(s.value);break;case"v2":this.uniforms[i].value=new ct().fromArray(s.value);break;case"v3":this.uniforms[i].value=new O().fromArray(s.value);break;case"v4":this.uniforms[i].value=new an().fromArray(s.value);break;case"m3":this.uniforms[i].value=new it().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Mt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},ea=class extends vs{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var qr=class extends _s{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new st(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new st(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=wh,this.normalScale=new ct(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Qi,this.combine=Bu,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Eu=class extends _s{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Y_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Tu=class extends _s{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ho(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function tu(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var gr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Au=class extends gr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:If,endingEnd:If}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Lf:r=e,a=2*t-i;break;case Df:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Lf:o=e,l=2*i-t;break;case Df:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,d=this._offsetNext,h=this._weightPrev,f=this._weightNext,g=(i-t)/(s-t),y=g*g,p=y*g,m=-h*p+2*h*y-h*g,x=(1+h)*p+(-1.5-2*h)*y+(-.5+h)*g+1,E=(-1-f)*p+(1.5+f)*y+.5*g,S=f*p-f*y;for(let R=0;R!==a;++R)r[R]=m*o[u+R]+x*o[c+R]+E*o[l+R]+S*o[d+R];return r}},Cu=class extends gr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),d=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*d+o[l+h]*u;return r}},Ru=class extends gr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Pu=class extends gr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let g=(i-t)/(s-t),y=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*g;return r}let h=a*2,f=e-1;for(let g=0;g!==a;++g){let y=o[c+g],p=o[l+g],m=f*h+g*2,x=d[m],E=d[m+1],S=e*h+g*2,R=u[S],C=u[S+1],v=JM(i,t,x,R,s);r[g]=cv(v,y,E,C,p)}return r}};function cv(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function KM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function JM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=cv(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=KM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Li=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ho(t,this.TimeBufferType),this.values=Ho(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Ho(e.times,Array),values:Ho(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),tu(e.settings)&&(i.settings={inTangents:Ho(e.settings.inTangents,Array),outTangents:Ho(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Ru(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Cu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Au(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Pu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Va:t=this.InterpolantFactoryMethodDiscrete;break;case gu:t=this.InterpolantFactoryMethodLinear;break;case su:t=this.InterpolantFactoryMethodSmooth;break;case Pf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Va;case this.InterpolantFactoryMethodLinear:return gu;case this.InterpolantFactoryMethodSmooth:return su;case this.InterpolantFactoryMethodBezier:return Pf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;tu(this.settings)&&(m_(this.settings.inTangents,e),m_(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;tu(this.settings)&&(g_(this.settings.inTangents,e),g_(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(tt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(tt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){tt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){tt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&EM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){tt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===su,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let d=a*i,h=d-i,f=d+i;for(let g=0;g!==i;++g){let y=t[d+g];if(y!==t[h+g]||y!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*i,h=o*i;for(let f=0;f!==i;++f)t[h+f]=t[d+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,tu(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function m_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function g_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Li.prototype.ValueTypeName="";Li.prototype.TimeBufferType=Float32Array;Li.prototype.ValueBufferType=Float32Array;Li.prototype.DefaultInterpolation=gu;var _r=class extends Li{constructor(e,t,i){super(e,t,i)}};_r.prototype.ValueTypeName="bool";_r.prototype.ValueBufferType=Array;_r.prototype.DefaultInterpolation=Va;_r.prototype.InterpolantFactoryMethodLinear=void 0;_r.prototype.InterpolantFactoryMethodSmooth=void 0;var Iu=class extends Li{constructor(e,t,i,s){super(e,t,i,s)}};Iu.prototype.ValueTypeName="color";var Lu=class extends Li{constructor(e,t,i,s){super(e,t,i,s)}};Lu.prototype.ValueTypeName="number";var Du=class extends gr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)$t.slerpFlat(r,0,o,c-a,o,c,l);return r}},el=class extends Li{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Du(this.times,this.values,this.getValueSize(),e)}};el.prototype.ValueTypeName="quaternion";el.prototype.InterpolantFactoryMethodSmooth=void 0;var vr=class extends Li{constructor(e,t,i){super(e,t,i)}};vr.prototype.ValueTypeName="string";vr.prototype.ValueBufferType=Array;vr.prototype.DefaultInterpolation=Va;vr.prototype.InterpolantFactoryMethodLinear=void 0;vr.prototype.InterpolantFactoryMethodSmooth=void 0;var Nu=class extends Li{constructor(e,t,i,s){super(e,t,i,s)}};Nu.prototype.ValueTypeName="vector";var Fu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,d){return c.push(u,d),this},this.removeHandler=function(u){let d=c.indexOf(u);return d!==-1&&c.splice(d,2),this},this.getHandler=function(u){for(let d=0,h=c.length;d<h;d+=2){let f=c[d],g=c[d+1];if(f.global&&(f.lastIndex=0),f.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},uv=new Fu,Uu=class{constructor(e){this.manager=e!==void 0?e:uv,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Uu.DEFAULT_MATERIAL_NAME="__DEFAULT";var tl=class extends ln{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new st(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},nl=class extends tl{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(ln.DEFAULT_UP),this.updateMatrix(),this.groundColor=new st(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Rf=new Mt,__=new O,v_=new O,Ou=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ct(512,512),this.mapType=Kn,this.map=null,this.mapPass=null,this.matrix=new Mt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new fr,this._frameExtents=new ct(1,1),this._viewportCount=1,this._viewports=[new an(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;__.setFromMatrixPosition(e.matrixWorld),t.position.copy(__),v_.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(v_),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Rf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Rf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===$o||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Rf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},nu=new O,iu=new $t,ps=new O,il=class extends ln{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Mt,this.projectionMatrix=new Mt,this.projectionMatrixInverse=new Mt,this.coordinateSystem=zi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(nu,iu,ps),ps.x===1&&ps.y===1&&ps.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(nu,iu,ps.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(nu,iu,ps),ps.x===1&&ps.y===1&&ps.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(nu,iu,ps.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},hr=new O,x_=new ct,y_=new ct,fi=class extends il{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=_u*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(ou*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return _u*2*Math.atan(Math.tan(ou*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){hr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(hr.x,hr.y).multiplyScalar(-e/hr.z),hr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(hr.x,hr.y).multiplyScalar(-e/hr.z)}getViewSize(e,t){return this.getViewBounds(e,x_,y_),t.subVectors(y_,x_)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(ou*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var sl=class extends il{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Ff=class extends Ou{constructor(){super(new sl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},rl=class extends tl{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(ln.DEFAULT_UP),this.updateMatrix(),this.target=new ln,this.shadow=new Ff}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Wo=-90,Xo=1,ta=class extends ln{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new fi(Wo,Xo,e,t);s.layers=this.layers,this.add(s);let r=new fi(Wo,Xo,e,t);r.layers=this.layers,this.add(r);let o=new fi(Wo,Xo,e,t);o.layers=this.layers,this.add(o);let a=new fi(Wo,Xo,e,t);a.layers=this.layers,this.add(a);let l=new fi(Wo,Xo,e,t);l.layers=this.layers,this.add(l);let c=new fi(Wo,Xo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===zi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===$o)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,d=e.getRenderTarget(),h=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=y,e.setRenderTarget(i,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(d,h,f),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},ku=class extends fi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var dp="\\[\\]\\.:\\/",QM=new RegExp("["+dp+"]","g"),fp="[^"+dp+"]",jM="[^"+dp.replace("\\.","")+"]",ew=/((?:WC+[\/:])*)/.source.replace("WC",fp),tw=/(WCOD+)?/.source.replace("WCOD",jM),nw=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",fp),iw=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",fp),sw=new RegExp("^"+ew+tw+nw+iw+"$"),rw=["material","materials","bones","map"],Uf=class{constructor(e,t,i){let s=i||nn.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},nn=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(QM,"")}static parseTrackName(e){let t=sw.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);rw.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){tt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){tt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){tt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){tt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){tt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;tt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};nn.Composite=Uf;nn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};nn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};nn.prototype.GetterByBindingType=[nn.prototype._getValue_direct,nn.prototype._getValue_array,nn.prototype._getValue_arrayElement,nn.prototype._getValue_toArray];nn.prototype.SetterByBindingTypeAndVersioning=[[nn.prototype._setValue_direct,nn.prototype._setValue_direct_setNeedsUpdate,nn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_array,nn.prototype._setValue_array_setNeedsUpdate,nn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_arrayElement,nn.prototype._setValue_arrayElement_setNeedsUpdate,nn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_fromArray,nn.prototype._setValue_fromArray_setNeedsUpdate,nn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var u2=new Float32Array(1);var b_=new Mt,xr=class{constructor(e,t,i=0,s=1/0){this.ray=new Vr(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new Jo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):tt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return b_.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(b_),this}intersectObject(e,t=!0,i=[]){return Of(e,this,i,t),i.sort(S_),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)Of(e[s],this,i,t);return i.sort(S_),i}};function S_(n,e){return n.distance-e.distance}function Of(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Of(r[o],e,t,!0)}}var kf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var ol=class extends pr{constructor(e=10,t=10,i=4473924,s=8947848){i=new st(i),s=new st(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let h=0,f=0,g=-a;h<=t;h++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let y=h===r?i:s;y.toArray(c,f),f+=3,y.toArray(c,f),f+=3,y.toArray(c,f),f+=3,y.toArray(c,f),f+=3}let u=new Nt;u.setAttribute("position",new mt(l,3)),u.setAttribute("color",new mt(c,3));let d=new xi({vertexColors:!0,toneMapped:!1});super(u,d),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var al=class extends pr{constructor(e,t=16776960){let i=new Uint16Array([0,1,1,2,2,3,3,0,4,5,5,6,6,7,7,4,0,4,1,5,2,6,3,7]),s=[1,1,1,-1,1,1,-1,-1,1,1,-1,1,1,1,-1,-1,1,-1,-1,-1,-1,1,-1,-1],r=new Nt;r.setIndex(new Zn(i,1)),r.setAttribute("position",new mt(s,3)),super(r,new xi({color:t,toneMapped:!1})),this.box=e,this.type="Box3Helper",this.geometry.computeBoundingSphere()}updateMatrixWorld(e){let t=this.box;t.isEmpty()||(t.getCenter(this.position),t.getSize(this.scale),this.scale.multiplyScalar(.5),super.updateMatrixWorld(e))}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var ll=class extends Ji{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function pp(n,e,t,i){let s=ow(i);switch(t){case ip:return n*e;case rp:return n*e/s.components*s.byteLength;case ra:return n*e/s.components*s.byteLength;case br:return n*e*2/s.components*s.byteLength;case qu:return n*e*2/s.components*s.byteLength;case sp:return n*e*3/s.components*s.byteLength;case Di:return n*e*4/s.components*s.byteLength;case Yu:return n*e*4/s.components*s.byteLength;case hl:case dl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case fl:case pl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Zu:case Ju:return Math.max(n,16)*Math.max(e,8)/4;case $u:case Ku:return Math.max(n,8)*Math.max(e,8)/2;case Qu:case ju:case th:case nh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case eh:case ml:case ih:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case sh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case rh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case oh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case ah:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case lh:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case ch:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case uh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case hh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case dh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case fh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case ph:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case mh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case gh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case _h:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case vh:case xh:case yh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case bh:case Sh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case gl:case Mh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function ow(n){switch(n){case Kn:case jf:return{byteLength:1,components:1};case yr:case ep:case ns:return{byteLength:2,components:1};case Wu:case Xu:return{byteLength:2,components:4};case es:case Hu:case ts:return{byteLength:4,components:1};case tp:case np:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Lv(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function lw(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,d=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let u=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,u);else{d.sort((f,g)=>f.start-g.start);let h=0;for(let f=1;f<d.length;f++){let g=d[h],y=d[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++h,d[h]=y)}d.length=h+1;for(let f=0,g=d.length;f<g;f++){let y=d[f];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var cw=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,uw=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,hw=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,dw=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,fw=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,pw=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,mw=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,gw=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,_w=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,vw=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,xw=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,yw=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,bw=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Sw=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Mw=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,ww=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Ew=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Tw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Aw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Cw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Rw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Pw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Iw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Lw=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Dw=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Nw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Fw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Uw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Ow=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,kw="gl_FragColor = linearToOutputTexel( gl_FragColor );",Bw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,zw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Vw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Gw=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Hw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Ww=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Xw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,qw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Yw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,$w=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Zw=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Kw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Jw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Qw=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,jw=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,e1=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,t1=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,n1=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,i1=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,s1=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,r1=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,o1=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,a1=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,l1=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,c1=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,u1=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,h1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,d1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,f1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,p1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,m1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,g1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,_1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,v1=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,x1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,y1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,b1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,S1=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,M1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,w1=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,E1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,T1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,A1=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,C1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,R1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,P1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,I1=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,L1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,D1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,N1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,F1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,U1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,O1=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,k1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,B1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,z1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,V1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,G1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,H1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,W1=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,X1=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,q1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Y1=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,$1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Z1=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,K1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,J1=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Q1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,j1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,eE=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,tE=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,nE=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,iE=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,sE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,rE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,oE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,aE=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,lE=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,cE=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,uE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,hE=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,dE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,fE=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,pE=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,mE=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,gE=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,_E=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,vE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,xE=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yE=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,bE=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,SE=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,ME=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,wE=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,EE=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,TE=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,AE=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,CE=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,RE=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,PE=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,IE=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,LE=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,DE=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,NE=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,FE=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,UE=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,OE=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,kE=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,BE=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,zE=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,VE=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ft={alphahash_fragment:cw,alphahash_pars_fragment:uw,alphamap_fragment:hw,alphamap_pars_fragment:dw,alphatest_fragment:fw,alphatest_pars_fragment:pw,aomap_fragment:mw,aomap_pars_fragment:gw,batching_pars_vertex:_w,batching_vertex:vw,begin_vertex:xw,beginnormal_vertex:yw,bsdfs:bw,iridescence_fragment:Sw,bumpmap_pars_fragment:Mw,clipping_planes_fragment:ww,clipping_planes_pars_fragment:Ew,clipping_planes_pars_vertex:Tw,clipping_planes_vertex:Aw,color_fragment:Cw,color_pars_fragment:Rw,color_pars_vertex:Pw,color_vertex:Iw,common:Lw,defaultnormal_vertex:Dw,displacementmap_pars_vertex:Nw,displacementmap_vertex:Fw,emissivemap_fragment:Uw,emissivemap_pars_fragment:Ow,colorspace_fragment:kw,colorspace_pars_fragment:Bw,envmap_fragment:zw,envmap_common_pars_fragment:Vw,envmap_pars_fragment:Gw,envmap_pars_vertex:Hw,envmap_physical_pars_fragment:e1,envmap_vertex:Ww,fog_vertex:Xw,fog_pars_vertex:qw,fog_fragment:Yw,fog_pars_fragment:$w,gradientmap_pars_fragment:Zw,lightmap_pars_fragment:Kw,lights_lambert_fragment:Jw,lights_lambert_pars_fragment:Qw,lights_pars_begin:jw,lights_toon_fragment:t1,lights_toon_pars_fragment:n1,lights_phong_fragment:i1,lights_phong_pars_fragment:s1,lights_physical_fragment:r1,lights_physical_pars_fragment:o1,lights_fragment_begin:a1,lights_fragment_maps:l1,lights_fragment_end:c1,lightprobes_pars_fragment:u1,logdepthbuf_fragment:h1,logdepthbuf_pars_fragment:d1,logdepthbuf_pars_vertex:f1,logdepthbuf_vertex:p1,map_fragment:m1,map_pars_fragment:g1,map_particle_fragment:_1,map_particle_pars_fragment:v1,metalnessmap_fragment:x1,metalnessmap_pars_fragment:y1,morphinstance_vertex:b1,morphcolor_vertex:S1,morphnormal_vertex:M1,morphtarget_pars_vertex:w1,morphtarget_vertex:E1,normal_fragment_begin:T1,normal_fragment_maps:A1,normal_pars_fragment:C1,normal_pars_vertex:R1,normal_vertex:P1,normalmap_pars_fragment:I1,clearcoat_normal_fragment_begin:L1,clearcoat_normal_fragment_maps:D1,clearcoat_pars_fragment:N1,iridescence_pars_fragment:F1,opaque_fragment:U1,packing:O1,premultiplied_alpha_fragment:k1,project_vertex:B1,dithering_fragment:z1,dithering_pars_fragment:V1,roughnessmap_fragment:G1,roughnessmap_pars_fragment:H1,shadowmap_pars_fragment:W1,shadowmap_pars_vertex:X1,shadowmap_vertex:q1,shadowmask_pars_fragment:Y1,skinbase_vertex:$1,skinning_pars_vertex:Z1,skinning_vertex:K1,skinnormal_vertex:J1,specularmap_fragment:Q1,specularmap_pars_fragment:j1,tonemapping_fragment:eE,tonemapping_pars_fragment:tE,transmission_fragment:nE,transmission_pars_fragment:iE,uv_pars_fragment:sE,uv_pars_vertex:rE,uv_vertex:oE,worldpos_vertex:aE,background_vert:lE,background_frag:cE,backgroundCube_vert:uE,backgroundCube_frag:hE,cube_vert:dE,cube_frag:fE,depth_vert:pE,depth_frag:mE,distance_vert:gE,distance_frag:_E,equirect_vert:vE,equirect_frag:xE,linedashed_vert:yE,linedashed_frag:bE,meshbasic_vert:SE,meshbasic_frag:ME,meshlambert_vert:wE,meshlambert_frag:EE,meshmatcap_vert:TE,meshmatcap_frag:AE,meshnormal_vert:CE,meshnormal_frag:RE,meshphong_vert:PE,meshphong_frag:IE,meshphysical_vert:LE,meshphysical_frag:DE,meshtoon_vert:NE,meshtoon_frag:FE,points_vert:UE,points_frag:OE,shadow_vert:kE,shadow_frag:BE,sprite_vert:zE,sprite_frag:VE},Ne={common:{diffuse:{value:new st(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new it}},envmap:{envMap:{value:null},envMapRotation:{value:new it},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new it}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new it}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new it},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new it},normalScale:{value:new ct(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new it},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new it}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new it}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new it}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new st(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new st(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0},uvTransform:{value:new it}},sprite:{diffuse:{value:new st(16777215)},opacity:{value:1},center:{value:new ct(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}}},Ss={basic:{uniforms:si([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:si([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new st(0)},envMapIntensity:{value:1}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:si([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new st(0)},specular:{value:new st(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:si([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new st(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:si([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new st(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:si([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:si([Ne.points,Ne.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:si([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:si([Ne.common,Ne.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:si([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:si([Ne.sprite,Ne.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new it},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new it}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distance:{uniforms:si([Ne.common,Ne.displacementmap,{referencePosition:{value:new O},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distance_vert,fragmentShader:ft.distance_frag},shadow:{uniforms:si([Ne.lights,Ne.fog,{color:{value:new st(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};Ss.physical={uniforms:si([Ss.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new it},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new it},clearcoatNormalScale:{value:new ct(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new it},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new it},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new it},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new it},sheen:{value:0},sheenColor:{value:new st(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new it},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new it},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new it},transmissionSamplerSize:{value:new ct},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new it},attenuationDistance:{value:0},attenuationColor:{value:new st(0)},specularColor:{value:new st(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new it},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new it},anisotropyVector:{value:new ct},anisotropyMap:{value:null},anisotropyMapTransform:{value:new it}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var Eh={r:0,b:0,g:0},GE=new Mt,Dv=new it;Dv.set(-1,0,0,0,1,0,0,0,1);function HE(n,e,t,i,s,r){let o=new st(0),a=s===!0?0:1,l,c,u=null,d=0,h=null;function f(x){let E=x.isScene===!0?x.background:null;if(E&&E.isTexture){let S=x.backgroundBlurriness>0;E=e.get(E,S)}return E}function g(x){let E=!1,S=f(x);S===null?p(o,a):S&&S.isColor&&(p(S,1),E=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||E)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(x,E){let S=f(E);S&&S.isCubeTexture?(c===void 0&&(c=new Le(new Zt(1,1,1),new vs({name:"BackgroundCubeMaterial",uniforms:Jr(Ss.backgroundCube.uniforms),vertexShader:Ss.backgroundCube.vertexShader,fragmentShader:Ss.backgroundCube.fragmentShader,side:mi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,C,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(GE.makeRotationFromEuler(E.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Dv),c.material.toneMapped=St.getTransfer(S.colorSpace)!==Dt,(u!==S||d!==S.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,d=S.version,h=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Le(new Wr(2,2),new vs({name:"BackgroundMaterial",uniforms:Jr(Ss.background.uniforms),vertexShader:Ss.background.vertexShader,fragmentShader:Ss.background.fragmentShader,side:xs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=St.getTransfer(S.colorSpace)!==Dt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||d!==S.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,d=S.version,h=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function p(x,E){x.getRGB(Eh,hp(n)),t.buffers.color.setClear(Eh.r,Eh.g,Eh.b,E,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,E=1){o.set(x),a=E,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,p(o,a)},render:g,addToRenderList:y,dispose:m}}function WE(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(D,z,G,N,W){let $=!1,H=d(D,N,G,z);r!==H&&(r=H,c(r.object)),$=f(D,N,G,W),$&&g(D,N,G,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,S(D,z,G,N),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function u(D){return n.deleteVertexArray(D)}function d(D,z,G,N){let W=N.wireframe===!0,$=i[z.id];$===void 0&&($={},i[z.id]=$);let H=D.isInstancedMesh===!0?D.id:0,le=$[H];le===void 0&&(le={},$[H]=le);let Y=le[G.id];Y===void 0&&(Y={},le[G.id]=Y);let j=Y[W];return j===void 0&&(j=h(l()),Y[W]=j),j}function h(D){let z=[],G=[],N=[];for(let W=0;W<t;W++)z[W]=0,G[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:G,attributeDivisors:N,object:D,attributes:{},index:null}}function f(D,z,G,N){let W=r.attributes,$=z.attributes,H=0,le=G.getAttributes();for(let Y in le)if(le[Y].location>=0){let ie=W[Y],he=$[Y];if(he===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(he=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(he=D.instanceColor)),ie===void 0||ie.attribute!==he||he&&ie.data!==he.data)return!0;H++}return r.attributesNum!==H||r.index!==N}function g(D,z,G,N){let W={},$=z.attributes,H=0,le=G.getAttributes();for(let Y in le)if(le[Y].location>=0){let ie=$[Y];ie===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(ie=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(ie=D.instanceColor));let he={};he.attribute=ie,ie&&ie.data&&(he.data=ie.data),W[Y]=he,H++}r.attributes=W,r.attributesNum=H,r.index=N}function y(){let D=r.newAttributes;for(let z=0,G=D.length;z<G;z++)D[z]=0}function p(D){m(D,0)}function m(D,z){let G=r.newAttributes,N=r.enabledAttributes,W=r.attributeDivisors;G[D]=1,N[D]===0&&(n.enableVertexAttribArray(D),N[D]=1),W[D]!==z&&(n.vertexAttribDivisor(D,z),W[D]=z)}function x(){let D=r.newAttributes,z=r.enabledAttributes;for(let G=0,N=z.length;G<N;G++)z[G]!==D[G]&&(n.disableVertexAttribArray(G),z[G]=0)}function E(D,z,G,N,W,$,H){H===!0?n.vertexAttribIPointer(D,z,G,W,$):n.vertexAttribPointer(D,z,G,N,W,$)}function S(D,z,G,N){y();let W=N.attributes,$=G.getAttributes(),H=z.defaultAttributeValues;for(let le in $){let Y=$[le];if(Y.location>=0){let j=W[le];if(j===void 0&&(le==="instanceMatrix"&&D.instanceMatrix&&(j=D.instanceMatrix),le==="instanceColor"&&D.instanceColor&&(j=D.instanceColor)),j!==void 0){let ie=j.normalized,he=j.itemSize,de=e.get(j);if(de===void 0)continue;let ee=de.buffer,me=de.type,ve=de.bytesPerElement,Ce=me===n.INT||me===n.UNSIGNED_INT||j.gpuType===Hu;if(j.isInterleavedBufferAttribute){let Se=j.data,Ye=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,at=j.offset;if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let Xe=0;Xe<Y.locationSize;Xe++)m(Y.location+Xe,Se.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let Xe=0;Xe<Y.locationSize;Xe++)p(Y.location+Xe);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Xe=0;Xe<Y.locationSize;Xe++)E(Y.location+Xe,he/Y.locationSize,me,ie,Ye*ve,(at+he/Y.locationSize*Xe)*ve,Ce)}else{if(j.isInstancedBufferAttribute){for(let Se=0;Se<Y.locationSize;Se++)m(Y.location+Se,j.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let Se=0;Se<Y.locationSize;Se++)p(Y.location+Se);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Se=0;Se<Y.locationSize;Se++)E(Y.location+Se,he/Y.locationSize,me,ie,he*ve,he/Y.locationSize*Se*ve,Ce)}}else if(H!==void 0){let ie=H[le];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(Y.location,ie);break;case 3:n.vertexAttrib3fv(Y.location,ie);break;case 4:n.vertexAttrib4fv(Y.location,ie);break;default:n.vertexAttrib1fv(Y.location,ie)}}}}x()}function R(){U();for(let D in i){let z=i[D];for(let G in z){let N=z[G];for(let W in N){let $=N[W];for(let H in $)u($[H].object),delete $[H];delete N[W]}}delete i[D]}}function C(D){if(i[D.id]===void 0)return;let z=i[D.id];for(let G in z){let N=z[G];for(let W in N){let $=N[W];for(let H in $)u($[H].object),delete $[H];delete N[W]}}delete i[D.id]}function v(D){for(let z in i){let G=i[z];for(let N in G){let W=G[N];if(W[D.id]===void 0)continue;let $=W[D.id];for(let H in $)u($[H].object),delete $[H];delete W[D.id]}}}function w(D){for(let z in i){let G=i[z],N=D.isInstancedMesh===!0?D.id:0,W=G[N];if(W!==void 0){for(let $ in W){let H=W[$];for(let le in H)u(H[le].object),delete H[le];delete W[$]}delete G[N],Object.keys(G).length===0&&delete i[z]}}}function U(){I(),o=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:I,dispose:R,releaseStatesOfGeometry:C,releaseStatesOfObject:w,releaseStatesOfProgram:v,initAttributes:y,enableAttribute:p,disableUnusedAttributes:x}}function XE(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let f=0;f<u;f++)h+=c[f];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function qE(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==Di&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let w=v===ns&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==Kn&&v!==ts&&!w&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Je("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&Je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&Je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),C=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:x,maxVaryings:E,maxFragmentUniforms:S,maxSamples:R,samples:C}}function YE(n){let e=this,t=null,i=0,s=!1,r=!1,o=new di,a=new it,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,h){let f=d.length!==0||h||i!==0||s;return s=h,i=d.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,h){t=u(d,h,0)},this.setState=function(d,h,f){let g=d.clippingPlanes,y=d.clipIntersection,p=d.clipShadows,m=n.get(d);if(!s||g===null||g.length===0||r&&!p)r?u(null):c();else{let x=r?0:i,E=x*4,S=m.clippingState||null;l.value=S,S=u(g,h,E,f);for(let R=0;R!==E;++R)S[R]=t[R];m.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(d,h,f,g){let y=d!==null?d.length:0,p=null;if(y!==0){if(p=l.value,g!==!0||p===null){let m=f+y*4,x=h.matrixWorldInverse;a.getNormalMatrix(x),(p===null||p.length<m)&&(p=new Float32Array(m));for(let E=0,S=f;E!==y;++E,S+=4)o.copy(d[E]).applyMatrix4(x,a),o.normal.toArray(p,S),p[S+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,p}}var bl=class extends Ii{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Ka(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Zt(5,5,5),r=new vs({name:"CubemapFromEquirect",uniforms:Jr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:mi,blending:Yr});r.uniforms.tEquirect.value=t;let o=new Le(s,r),a=t.minFilter;return t.minFilter===Hs&&(t.minFilter=pi),new ta(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},hv=256,$E=3,ZE=20,Nv=256,Fv=16,KE=3,JE=new O,QE=new st,Ah=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ta(1,10,null),this._boxMesh=new Le(new Zt(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=JE}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,h=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(QE));let p=new ta(i,s,u);return p.position.copy(a),p.update(l,e),l.autoClear=d,l.autoClearColor=h,l.autoClearDepth=f,l.autoClearStencil=g,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=pv(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=fv(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(hv,ov(e))}_fromTexture(e,t){e.mapping===Zr||e.mapping===sa?this._setSize(e.image.length===0?hv:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=dv(e,!1,!1),i=Math.log2(e)-$E;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=dv(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Zr||e.mapping===sa?(this._cubemapMaterial===null&&(this._cubemapMaterial=pv()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=fv()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=jE(),this._integrationMaterial=eT());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Fv);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-KE)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Nv*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=tT());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function dv(n,e,t){return new bl(n,{minFilter:Hs,generateMipmaps:e,type:ns,colorSpace:Ga,depthBuffer:t})}function Sl(n,e,t){return new vs({name:n,uniforms:e,vertexShader:ft.cube_vert,fragmentShader:t,side:mi,blending:Yr,depthTest:!1,depthWrite:!1})}function jE(){return Sl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Nv}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function eT(){return Sl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Fv}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function tT(){return Sl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${ZE}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function fv(){return Sl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function pv(){return Sl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function nT(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,f=!1){return h==null?null:f?o(h):r(h)}function r(h){if(h&&h.isTexture){let f=h.mapping;if(f===zu||f===Vu)if(e.has(h)){let g=e.get(h).texture;return a(g,h.mapping)}else{let g=h.image;if(g&&g.height>0){let y=new bl(g.height);return y.fromEquirectangularTexture(n,h),e.set(h,y),h.addEventListener("dispose",c),a(y.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let f=h.mapping,g=f===zu||f===Vu,y=f===Zr||f===sa;if(g||y){let p=t.get(h),m=p!==void 0?p.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return i===null&&(i=new Ah(n)),p=g?i.fromEquirectangular(h,p):i.fromCubemap(h,p),p.texture.pmremVersion=h.pmremVersion,t.set(h,p),p.texture;if(p!==void 0)return p.texture;{let x=h.image;return g&&x&&x.height>0||y&&x&&l(x)?(i===null&&(i=new Ah(n)),p=g?i.fromEquirectangular(h):i.fromCubemap(h),p.texture.pmremVersion=h.pmremVersion,t.set(h,p),h.addEventListener("dispose",u),p.texture):null}}}return h}function a(h,f){return f===zu?h.mapping=Zr:f===Vu&&(h.mapping=sa),h}function l(h){let f=0,g=6;for(let y=0;y<g;y++)h[y]!==void 0&&f++;return f===g}function c(h){let f=h.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function u(h){let f=h.target;f.removeEventListener("dispose",u);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function d(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function iT(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&za("WebGLRenderer: "+i+" extension not supported."),s}}}function sT(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let p in g.attributes)e.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(e.remove(y),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function u(g){let y=g.attributes;for(let p in y)e.update(y[p],n.ARRAY_BUFFER)}function d(g){let y=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let x=y!==null?y.array.length:p.array.length/3-1,E=p.count>=65535?$a:Ya,S=new E(Math.ceil(x/3)*6,1),R=S.array;if(y!==null){let v=y.array;m=y.version;for(let w=0,U=0;w<x;w+=3){let I=v[w+0],D=v[w+1],z=v[w+2];R[U++]=I,R[U++]=D,R[U++]=D,R[U++]=z,R[U++]=z,R[U++]=I}}else{m=p.version;for(let v=0,w=0;v<x;v+=3){let U=v+0,I=v+1,D=v+2;R[w++]=U,R[w++]=I,R[w++]=I,R[w++]=D,R[w++]=D,R[w++]=U}}S.version=m;let C=r.get(g);C&&e.remove(C),r.set(g,S)}function h(g){let y=r.get(g);if(y){let p=g.index;p!==null&&y.version<p.version&&d(g)}else d(g);return r.get(g)}function f(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:h,dispose:f}}function rT(n,e,t){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,h){n.drawElements(i,h,r,d*o),t.update(h,i,1)}function c(d,h,f){f!==0&&(n.drawElementsInstanced(i,h,r,d*o,f),t.update(h,i,f))}function u(d,h,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,d,0,f);let y=0;for(let p=0;p<f;p++)y+=h[p];t.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function oT(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:tt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function aT(n,e,t){let i=new WeakMap,s=new an;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==d){let U=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",U)};h!==void 0&&h.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],E=0;f===!0&&(E=1),g===!0&&(E=2),y===!0&&(E=3);let S=a.attributes.position.count*E,R=1;S>e.maxTextureSize&&(R=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let C=new Float32Array(S*R*4*d),v=new Xa(C,S,R,d);v.type=ts,v.needsUpdate=!0;let w=E*4;for(let I=0;I<d;I++){let D=p[I],z=m[I],G=x[I],N=S*R*4*I;for(let W=0;W<D.count;W++){let $=W*w;f===!0&&(s.fromBufferAttribute(D,W),C[N+$+0]=s.x,C[N+$+1]=s.y,C[N+$+2]=s.z,C[N+$+3]=0),g===!0&&(s.fromBufferAttribute(z,W),C[N+$+4]=s.x,C[N+$+5]=s.y,C[N+$+6]=s.z,C[N+$+7]=0),y===!0&&(s.fromBufferAttribute(G,W),C[N+$+8]=s.x,C[N+$+9]=s.y,C[N+$+10]=s.z,C[N+$+11]=G.itemSize===4?s.w:1)}}h={count:d,texture:v,size:new ct(S,R)},i.set(a,h),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function lT(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,d=c.geometry,h=e.get(c,d);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var cT={[Xf]:"LINEAR_TONE_MAPPING",[qf]:"REINHARD_TONE_MAPPING",[Yf]:"CINEON_TONE_MAPPING",[$f]:"ACES_FILMIC_TONE_MAPPING",[Kf]:"AGX_TONE_MAPPING",[Jf]:"NEUTRAL_TONE_MAPPING",[Zf]:"CUSTOM_TONE_MAPPING"};function uT(n,e,t,i,s,r){let o=new Ii(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Nt;u.setAttribute("position",new mt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new mt([0,2,0,0,2,0],2));let d=new ea({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new Le(u,d),f=new sl(-1,1,1,-1,0,1),g=null,y=null,p=!1,m,x=null,E=[],S=!1;this.setSize=function(R,C){o.setSize(R,C),a!==null&&a.setSize(R,C),l!==null&&l.setSize(R,C);for(let v=0;v<E.length;v++){let w=E[v];w.setSize&&w.setSize(R,C)}},this.setEffects=function(R){E=R,S=E.length>0&&E[0].isRenderPass===!0;let C=o.width,v=o.height;E.length>0&&a===null&&(a=new Ii(C,v,{type:ns,depthBuffer:!1,stencilBuffer:!1}),l=new Ii(C,v,{type:ns,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&E.some(U=>U.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Vs(C,v),r===!0&&(c.format=Ws,c.type=Kr)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let U=0;U<E.length;U++){let I=E[U];I.setSize&&I.setSize(C,v),w&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(R,C){if(p||R.toneMapping===ys&&E.length===0)return!1;if(x=C,C!==null){let v=C.width,w=C.height;(o.width!==v||o.height!==w)&&this.setSize(v,w)}return S===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=ys,!0},this.hasRenderPass=function(){return S},this.end=function(R,C){R.toneMapping=m,p=!0;let v=o,w=a;for(let U=0;U<E.length;U++){let I=E[U];I.enabled!==!1&&(I.render(R,w,v,C),I.needsSwap!==!1&&(v=w,w=w===a?l:a))}if(g!==R.outputColorSpace||y!==R.toneMapping){g=R.outputColorSpace,y=R.toneMapping,d.defines={},St.getTransfer(g)===Dt&&(d.defines.SRGB_TRANSFER="");let U=cT[y];U&&(d.defines[U]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=v.texture,R.setRenderTarget(x),R.render(h,f),x=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),d.dispose()}}var Uv=new vi,Ov=new Vs(1,1),kv=new Ja(1),Bv=new Xa,zv=new yu,Vv=new Ka,mv=[],gv=[],_v=new Float32Array(16),vv=new Float32Array(9),xv=new Float32Array(4);function aa(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=mv[s];if(r===void 0&&(r=new Float32Array(s),mv[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function kn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Bn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Rh(n,e){let t=gv[e];t===void 0&&(t=new Int32Array(e),gv[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function hT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function dT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(kn(t,e))return;n.uniform2fv(this.addr,e),Bn(t,e)}}function fT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(kn(t,e))return;n.uniform3fv(this.addr,e),Bn(t,e)}}function pT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(kn(t,e))return;n.uniform4fv(this.addr,e),Bn(t,e)}}function mT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(kn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Bn(t,e)}else{if(kn(t,i))return;xv.set(i),n.uniformMatrix2fv(this.addr,!1,xv),Bn(t,i)}}function gT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(kn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Bn(t,e)}else{if(kn(t,i))return;vv.set(i),n.uniformMatrix3fv(this.addr,!1,vv),Bn(t,i)}}function _T(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(kn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Bn(t,e)}else{if(kn(t,i))return;_v.set(i),n.uniformMatrix4fv(this.addr,!1,_v),Bn(t,i)}}function vT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function xT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(kn(t,e))return;n.uniform2iv(this.addr,e),Bn(t,e)}}function yT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(kn(t,e))return;n.uniform3iv(this.addr,e),Bn(t,e)}}function bT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(kn(t,e))return;n.uniform4iv(this.addr,e),Bn(t,e)}}function ST(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function MT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(kn(t,e))return;n.uniform2uiv(this.addr,e),Bn(t,e)}}function wT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(kn(t,e))return;n.uniform3uiv(this.addr,e),Bn(t,e)}}function ET(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(kn(t,e))return;n.uniform4uiv(this.addr,e),Bn(t,e)}}function Ph(n){return n.version===0&&(n.compareFunction=lp,n.needsUpdate=!0),n}function TT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Ph(Ov):r=Uv,t.setTexture2D(e||r,s)}function AT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||zv,s)}function CT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Ph(kv):r=Vv,t.setTextureCube(e||r,s)}function RT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Bv,s)}function PT(n){switch(n){case 5126:return hT;case 35664:return dT;case 35665:return fT;case 35666:return pT;case 35674:return mT;case 35675:return gT;case 35676:return _T;case 5124:case 35670:return vT;case 35667:case 35671:return xT;case 35668:case 35672:return yT;case 35669:case 35673:return bT;case 5125:return ST;case 36294:return MT;case 36295:return wT;case 36296:return ET;case 35678:case 36198:case 36298:case 36306:case 35682:return TT;case 35679:case 36299:case 36307:return AT;case 35680:case 36300:case 36308:case 36293:return CT;case 36289:case 36303:case 36311:case 36292:return RT}}function IT(n,e){n.uniform1fv(this.addr,e)}function LT(n,e){let t=aa(e,this.size,2);n.uniform2fv(this.addr,t)}function DT(n,e){let t=aa(e,this.size,3);n.uniform3fv(this.addr,t)}function NT(n,e){let t=aa(e,this.size,4);n.uniform4fv(this.addr,t)}function FT(n,e){let t=aa(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function UT(n,e){let t=aa(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function OT(n,e){let t=aa(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function kT(n,e){n.uniform1iv(this.addr,e)}function BT(n,e){n.uniform2iv(this.addr,e)}function zT(n,e){n.uniform3iv(this.addr,e)}function VT(n,e){n.uniform4iv(this.addr,e)}function GT(n,e){n.uniform1uiv(this.addr,e)}function HT(n,e){n.uniform2uiv(this.addr,e)}function WT(n,e){n.uniform3uiv(this.addr,e)}function XT(n,e){n.uniform4uiv(this.addr,e)}function qT(n,e,t){let i=this.cache,s=e.length,r=Rh(t,s);kn(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Ph(Ov):o=Uv;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function YT(n,e,t){let i=this.cache,s=e.length,r=Rh(t,s);kn(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||zv,r[o])}function $T(n,e,t){let i=this.cache,s=e.length,r=Rh(t,s);kn(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Ph(kv):o=Vv;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function ZT(n,e,t){let i=this.cache,s=e.length,r=Rh(t,s);kn(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Bv,r[o])}function KT(n){switch(n){case 5126:return IT;case 35664:return LT;case 35665:return DT;case 35666:return NT;case 35674:return FT;case 35675:return UT;case 35676:return OT;case 5124:case 35670:return kT;case 35667:case 35671:return BT;case 35668:case 35672:return zT;case 35669:case 35673:return VT;case 5125:return GT;case 36294:return HT;case 36295:return WT;case 36296:return XT;case 35678:case 36198:case 36298:case 36306:case 35682:return qT;case 35679:case 36299:case 36307:return YT;case 35680:case 36300:case 36308:case 36293:return $T;case 36289:case 36303:case 36311:case 36292:return ZT}}var _p=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=PT(t.type)}},vp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=KT(t.type)}},xp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},mp=/(\w+)(\])?(\[|\.)?/g;function yv(n,e){n.seq.push(e),n.map[e.id]=e}function JT(n,e,t){let i=n.name,s=i.length;for(mp.lastIndex=0;;){let r=mp.exec(i),o=mp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){yv(t,c===void 0?new _p(a,n,e):new vp(a,n,e));break}else{let d=t.map[a];d===void 0&&(d=new xp(a),yv(t,d)),t=d}}}var oa=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);JT(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function bv(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var QT=37297,jT=0;function eA(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Sv=new it;function tA(n){St._getMatrix(Sv,St.workingColorSpace,n);let e=`mat3( ${Sv.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(n)){case Ha:return[e,"LinearTransferOETF"];case Dt:return[e,"sRGBTransferOETF"];default:return Je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Mv(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+eA(n.getShaderSource(e),a)}else return r}function nA(n,e){let t=tA(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var iA={[Xf]:"Linear",[qf]:"Reinhard",[Yf]:"Cineon",[$f]:"ACESFilmic",[Kf]:"AgX",[Jf]:"Neutral",[Zf]:"Custom"};function sA(n,e){let t=iA[e];return t===void 0?(Je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Th=new O;function rA(){St.getLuminanceCoefficients(Th);let n=Th.x.toFixed(4),e=Th.y.toFixed(4),t=Th.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function oA(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(yl).join(`
`)}function aA(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function lA(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function yl(n){return n!==""}function wv(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Ev(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var cA=/^[ \t]*#include +<([\w\d./]+)>/gm;function yp(n){return n.replace(cA,uA)}function uA(n,e){let t=ft[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return yp(t)}var hA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Tv(n){return n.replace(hA,dA)}function dA(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Av(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var fA={[cl]:"SHADOWMAP_TYPE_PCF",[na]:"SHADOWMAP_TYPE_VSM"};function pA(n){return fA[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var mA={[sa]:"ENVMAP_MODE_REFRACTION"};function gA(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":mA[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var _A={[Bu]:"ENVMAP_BLENDING_MULTIPLY",[W_]:"ENVMAP_BLENDING_MIX",[X_]:"ENVMAP_BLENDING_ADD"};function vA(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":_A[n.combine]||"ENVMAP_BLENDING_NONE"}function xA(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=pA(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=gA(t),d=vA(t),h=oA(t),f=aA(r),g=s.createProgram(),y,p,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(yl).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(yl).join(`
`),p.length>0&&(p+=`
`)):(y=[Av(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(yl).join(`
`),p=[Av(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ys?"#define TONE_MAPPING":"",t.toneMapping!==ys?ft.tonemapping_pars_fragment:"",t.toneMapping!==ys?sA("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,nA("linearToOutputTexel",t.outputColorSpace),rA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(yl).join(`
`)),o=yp(o),o=wv(o,t),o=Ev(o,t),a=yp(a),a=wv(a,t),a=Ev(a,t),o=Tv(o),a=Tv(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",t.glslVersion===_l?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===_l?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let x=m+y+o,E=m+p+a,S=bv(s,s.VERTEX_SHADER,x),R=bv(s,s.FRAGMENT_SHADER,E);s.attachShader(g,S),s.attachShader(g,R),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function C(I){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",z=s.getShaderInfoLog(S)||"",G=s.getShaderInfoLog(R)||"",N=D.trim(),W=z.trim(),$=G.trim(),H=!0,le=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,S,R);else{let Y=Mv(s,S,"vertex"),j=Mv(s,R,"fragment");tt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+N+`
`+Y+`
`+j)}else N!==""?Je("WebGLProgram: Program Info Log:",N):(W===""||$==="")&&(le=!1);le&&(I.diagnostics={runnable:H,programLog:N,vertexShader:{log:W,prefix:y},fragmentShader:{log:$,prefix:p}})}s.deleteShader(S),s.deleteShader(R),v=new oa(s,g),w=lA(s,g)}let v;this.getUniforms=function(){return v===void 0&&C(this),v};let w;this.getAttributes=function(){return w===void 0&&C(this),w};let U=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(g,QT)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=jT++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=R,this}var yA=0,bp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Sp(e),t.set(e,i)),i}},Sp=class{constructor(e){this.id=yA++,this.code=e,this.usedTimes=0}};function bA(n){return n===br||n===ml||n===gl}function SA(n,e,t,i,s,r){let o=new Jo,a=new bp,l=new Set,c=[],u=new Map,d=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function g(v,w,U,I,D,z){let G=I.fog,N=D.geometry,W=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?I.environment:null,$=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,H=e.get(v.envMap||W,$),le=h[v.type],Y=i.precision;v.precision!==null&&(Y=i.getMaxPrecision(v.precision),Y!==v.precision&&Je("WebGLProgram.getParameters:",v.precision,"not supported, using",Y,"instead."));let j=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ie=j!==void 0?j.length:0,he=0;N.morphAttributes.position!==void 0&&(he=1),N.morphAttributes.normal!==void 0&&(he=2),N.morphAttributes.color!==void 0&&(he=3);let de,ee,me,ve;if(le){let Re=Ss[le];de=Re.vertexShader,ee=Re.fragmentShader}else{de=v.vertexShader,ee=v.fragmentShader;let Re=a.getVertexShaderStage(v),ut=a.getFragmentShaderStage(v);a.update(v,Re,ut),me=Re.id,ve=ut.id}let Ce=n.getRenderTarget(),Se=n.state.buffers.depth.getReversed(),Ye=D.isInstancedMesh===!0,at=D.isBatchedMesh===!0,Xe=!!v.map,pt=!!v.matcap,ht=!!H,rt=ht&&H.isPMREMTexture===!0,sn=!!v.aoMap,Yt=!!v.lightMap,Mn=!!v.bumpMap&&v.wireframe===!1,zt=!!v.normalMap,zn=!!v.displacementMap,Et=!!v.emissiveMap,Dn=!!v.metalnessMap,dn=!!v.roughnessMap,wn=v.anisotropy>0,B=v.clearcoat>0,Pe=v.diffuseRoughness>0,Ke=v.dispersion>0,lt=v.retroreflectivity>0,Me=v.iridescence>0,Gt=v.sheen>0,We=v.transmission>0,Ze=wn&&!!v.anisotropyMap,P=B&&!!v.clearcoatMap,M=B&&!!v.clearcoatNormalMap,q=B&&!!v.clearcoatRoughnessMap,ue=Pe&&!!v.diffuseRoughnessMap,oe=Me&&!!v.iridescenceMap,_e=Me&&!!v.iridescenceThicknessMap,xe=Gt&&!!v.sheenColorMap,te=Gt&&!!v.sheenRoughnessMap,se=!!v.specularMap,pe=!!v.specularColorMap,k=!!v.specularIntensityMap,re=We&&!!v.transmissionMap,ne=We&&!!v.thicknessMap,we=!!v.gradientMap,ge=!!v.alphaMap,be=v.alphaTest>0,qe=!!v.alphaHash,je=!!v.extensions,ce=ys;v.toneMapped&&(Ce===null||Ce.isXRRenderTarget===!0)&&(ce=n.toneMapping);let Be=rt?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,et={shaderID:le,shaderType:v.type,shaderName:v.name,vertexShader:de,fragmentShader:ee,defines:v.defines,customVertexShaderID:me,customFragmentShaderID:ve,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:Y,batching:at,batchingColor:at&&D._colorsTexture!==null,instancing:Ye,instancingColor:Ye&&D.instanceColor!==null,instancingMorph:Ye&&D.morphTexture!==null,outputColorSpace:Ce===null?n.outputColorSpace:Ce.isXRRenderTarget===!0?Ce.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Xe,matcap:pt,envMap:ht,envMapMode:ht&&H.mapping,envMapPMREM:rt,envMapMaxLod:rt?Be.length-1:null,envMapSize:rt?Be[0].width:null,aoMap:sn,lightMap:Yt,bumpMap:Mn,normalMap:zt,displacementMap:zn,emissiveMap:Et,normalMapObjectSpace:zt&&v.normalMapType===$_,normalMapTangentSpace:zt&&v.normalMapType===wh,packedNormalMap:zt&&v.normalMapType===wh&&bA(v.normalMap.format),metalnessMap:Dn,roughnessMap:dn,anisotropy:wn,anisotropyMap:Ze,clearcoat:B,clearcoatMap:P,clearcoatNormalMap:M,clearcoatRoughnessMap:q,diffuseRoughness:Pe,diffuseRoughnessMap:ue,dispersion:Ke,retroreflection:lt,iridescence:Me,iridescenceMap:oe,iridescenceThicknessMap:_e,sheen:Gt,sheenColorMap:xe,sheenRoughnessMap:te,specularMap:se,specularColorMap:pe,specularIntensityMap:k,transmission:We,transmissionMap:re,thicknessMap:ne,gradientMap:we,opaque:v.transparent===!1&&v.blending===ia&&v.alphaToCoverage===!1,alphaMap:ge,alphaTest:be,alphaHash:qe,combine:v.combine,mapUv:Xe&&f(v.map.channel),aoMapUv:sn&&f(v.aoMap.channel),lightMapUv:Yt&&f(v.lightMap.channel),bumpMapUv:Mn&&f(v.bumpMap.channel),normalMapUv:zt&&f(v.normalMap.channel),displacementMapUv:zn&&f(v.displacementMap.channel),emissiveMapUv:Et&&f(v.emissiveMap.channel),metalnessMapUv:Dn&&f(v.metalnessMap.channel),roughnessMapUv:dn&&f(v.roughnessMap.channel),anisotropyMapUv:Ze&&f(v.anisotropyMap.channel),clearcoatMapUv:P&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:xe&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(v.sheenRoughnessMap.channel),specularMapUv:se&&f(v.specularMap.channel),specularColorMapUv:pe&&f(v.specularColorMap.channel),specularIntensityMapUv:k&&f(v.specularIntensityMap.channel),transmissionMapUv:re&&f(v.transmissionMap.channel),thicknessMapUv:ne&&f(v.thicknessMap.channel),alphaMapUv:ge&&f(v.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(zt||wn),vertexNormals:!!N.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!N.attributes.uv&&(Xe||ge),fog:!!G,useFog:v.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||N.attributes.normal===void 0&&zt===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:Se,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:he,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:z.filter(Re=>Re.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Xe&&v.map.isVideoTexture===!0&&St.getTransfer(v.map.colorSpace)===Dt,decodeVideoTextureEmissive:Et&&v.emissiveMap.isVideoTexture===!0&&St.getTransfer(v.emissiveMap.colorSpace)===Dt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===ii,flipSided:v.side===mi,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:je&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(je&&v.extensions.multiDraw===!0||at)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return et.vertexUv1s=l.has(1),et.vertexUv2s=l.has(2),et.vertexUv3s=l.has(3),l.clear(),et}function y(v){let w=[];if(v.shaderID?w.push(v.shaderID):(w.push(v.customVertexShaderID),w.push(v.customFragmentShaderID)),v.defines!==void 0)for(let U in v.defines)w.push(U),w.push(v.defines[U]);return v.isRawShaderMaterial===!1&&(p(w,v),m(w,v),w.push(n.outputColorSpace)),w.push(v.customProgramCacheKey),w.join()}function p(v,w){v.push(w.precision),v.push(w.outputColorSpace),v.push(w.envMapMode),v.push(w.envMapPMREM),v.push(w.envMapMaxLod),v.push(w.envMapSize),v.push(w.mapUv),v.push(w.alphaMapUv),v.push(w.lightMapUv),v.push(w.aoMapUv),v.push(w.bumpMapUv),v.push(w.normalMapUv),v.push(w.displacementMapUv),v.push(w.emissiveMapUv),v.push(w.metalnessMapUv),v.push(w.roughnessMapUv),v.push(w.anisotropyMapUv),v.push(w.clearcoatMapUv),v.push(w.clearcoatNormalMapUv),v.push(w.clearcoatRoughnessMapUv),v.push(w.diffuseRoughnessMapUv),v.push(w.iridescenceMapUv),v.push(w.iridescenceThicknessMapUv),v.push(w.sheenColorMapUv),v.push(w.sheenRoughnessMapUv),v.push(w.specularMapUv),v.push(w.specularColorMapUv),v.push(w.specularIntensityMapUv),v.push(w.transmissionMapUv),v.push(w.thicknessMapUv),v.push(w.combine),v.push(w.fogExp2),v.push(w.sizeAttenuation),v.push(w.morphTargetsCount),v.push(w.numSunLights),v.push(w.numDirLights),v.push(w.numPointLights),v.push(w.numSpotLights),v.push(w.numSpotLightMaps),v.push(w.numHemiLights),v.push(w.numRectAreaLights),v.push(w.numSunLightShadows),v.push(w.numDirLightShadows),v.push(w.numPointLightShadows),v.push(w.numSpotLightShadows),v.push(w.numSpotLightShadowsWithMaps),v.push(w.numLightProbes),v.push(w.numLightProbeGrids),v.push(w.shadowMapType),v.push(w.toneMapping),v.push(w.numClippingPlanes),v.push(w.numClipIntersection),v.push(w.depthPacking)}function m(v,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function x(v){let w=h[v.type],U;if(w){let I=Ss[w];U=lv.clone(I.uniforms)}else U=v.uniforms;return U}function E(v,w){let U=u.get(w);return U!==void 0?++U.usedTimes:(U=new xA(n,w,v,s),c.push(U),u.set(w,U)),U}function S(v){if(--v.usedTimes===0){let w=c.indexOf(v);c[w]=c[c.length-1],c.pop(),u.delete(v.cacheKey),v.destroy()}}function R(v){a.remove(v)}function C(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:x,acquireProgram:E,releaseProgram:S,releaseShaderCache:R,programs:c,dispose:C}}function MA(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function wA(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Cv(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Rv(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let f=0;return h.isInstancedMesh&&(f+=2),h.isSkinnedMesh&&(f+=1),f}function a(h,f,g,y,p,m){let x=n[e];return x===void 0?(x={id:h.id,object:h,geometry:f,material:g,materialVariant:o(h),groupOrder:y,renderOrder:h.renderOrder,z:p,group:m},n[e]=x):(x.id=h.id,x.object=h,x.geometry=f,x.material=g,x.materialVariant=o(h),x.groupOrder=y,x.renderOrder=h.renderOrder,x.z=p,x.group=m),e++,x}function l(h,f,g,y,p,m,x){x.reversedDepth===!0&&(p=-p);let E=a(h,f,g,y,p,m);g.transmission>0?i.push(E):g.transparent===!0?s.push(E):t.push(E)}function c(h,f,g,y,p,m){let x=a(h,f,g,y,p,m);g.transmission>0?i.unshift(x):g.transparent===!0?s.unshift(x):t.unshift(x)}function u(h,f){t.length>1&&t.sort(h||wA),i.length>1&&i.sort(f||Cv),s.length>1&&s.sort(f||Cv)}function d(){for(let h=e,f=n.length;h<f;h++){let g=n[h];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:u}}function EA(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Rv,n.set(i,[o])):s>=r.length?(o=new Rv,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function TA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new O,color:new st};break;case"SpotLight":t={position:new O,direction:new O,color:new st,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new O,color:new st,distance:0,decay:0};break;case"HemisphereLight":t={direction:new O,skyColor:new st,groundColor:new st};break;case"RectAreaLight":t={color:new st,position:new O,halfWidth:new O,halfHeight:new O};break}return n[e.id]=t,t}}}function AA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var CA=0;function RA(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function PA(n){let e=new TA,t=AA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new O);let s=new O,r=new Mt,o=new Mt;function a(c){let u=0,d=0,h=0;for(let z=0;z<9;z++)i.probe[z].set(0,0,0);let f=0,g=0,y=0,p=0,m=0,x=0,E=0,S=0,R=0,C=0,v=0,w=0,U=0,I=0;c.sort(RA);for(let z=0,G=c.length;z<G;z++){let N=c[z],W=N.color,$=N.intensity,H=N.distance,le=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===br?le=N.shadow.map.texture:le=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=W.r*$,d+=W.g*$,h+=W.b*$;else if(N.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(N.sh.coefficients[Y],$);I++}else if(N.isSunLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let j=N.shadow,ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[g]=ie,i.sunShadowMap[g]=le;let he=j.getViewportCount();for(let de=0;de<he;de++)i.sunShadowMatrix[y+de]=j.getMatrix(de),i.sunShadowCascade[y+de]=j._cascadeData[de];y+=he,g++}i.sun[f]=Y,f++}else if(N.isDirectionalLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let j=N.shadow,ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,i.directionalShadow[p]=ie,i.directionalShadowMap[p]=le,i.directionalShadowMatrix[p]=N.shadow.matrix,R++}i.directional[p]=Y,p++}else if(N.isSpotLight){let Y=e.get(N);Y.position.setFromMatrixPosition(N.matrixWorld),Y.color.copy(W).multiplyScalar($),Y.distance=H,Y.coneCos=Math.cos(N.angle),Y.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),Y.decay=N.decay,i.spot[x]=Y;let j=N.shadow;if(N.map&&(i.spotLightMap[w]=N.map,w++,j.updateMatrices(N),N.castShadow&&U++),i.spotLightMatrix[x]=j.matrix,N.castShadow){let ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,i.spotShadow[x]=ie,i.spotShadowMap[x]=le,v++}x++}else if(N.isRectAreaLight){let Y=e.get(N);Y.color.copy(W).multiplyScalar($),Y.halfWidth.set(N.width*.5,0,0),Y.halfHeight.set(0,N.height*.5,0),i.rectArea[E]=Y,E++}else if(N.isPointLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),Y.distance=N.distance,Y.decay=N.decay,N.castShadow){let j=N.shadow,ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,ie.shadowCameraNear=j.camera.near,ie.shadowCameraFar=j.camera.far,i.pointShadow[m]=ie,i.pointShadowMap[m]=le,i.pointShadowMatrix[m]=N.shadow.matrix,C++}i.point[m]=Y,m++}else if(N.isHemisphereLight){let Y=e.get(N);Y.skyColor.copy(N.color).multiplyScalar($),Y.groundColor.copy(N.groundColor).multiplyScalar($),i.hemi[S]=Y,S++}}E>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ne.LTC_FLOAT_1,i.rectAreaLTC2=Ne.LTC_FLOAT_2):(i.rectAreaLTC1=Ne.LTC_HALF_1,i.rectAreaLTC2=Ne.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=d,i.ambient[2]=h;let D=i.hash;(D.sunLength!==f||D.directionalLength!==p||D.pointLength!==m||D.spotLength!==x||D.rectAreaLength!==E||D.hemiLength!==S||D.numSunShadows!==g||D.numDirectionalShadows!==R||D.numPointShadows!==C||D.numSpotShadows!==v||D.numSpotMaps!==w||D.numLightProbes!==I)&&(i.sun.length=f,i.directional.length=p,i.spot.length=x,i.rectArea.length=E,i.point.length=m,i.hemi.length=S,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=C,i.pointShadowMap.length=C,i.pointShadowMatrix.length=C,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+w-U,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=I,D.sunLength=f,D.directionalLength=p,D.pointLength=m,D.spotLength=x,D.rectAreaLength=E,D.hemiLength=S,D.numSunShadows=g,D.numDirectionalShadows=R,D.numPointShadows=C,D.numSpotShadows=v,D.numSpotMaps=w,D.numLightProbes=I,i.version=CA++)}function l(c,u){let d=0,h=0,f=0,g=0,y=0,p=0,m=u.matrixWorldInverse;for(let x=0,E=c.length;x<E;x++){let S=c[x];if(S.isSunLight){let R=i.sun[d];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(m),d++}else if(S.isDirectionalLight){let R=i.directional[h];R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),h++}else if(S.isSpotLight){let R=i.spot[g];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),g++}else if(S.isRectAreaLight){let R=i.rectArea[y];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let R=i.point[f];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),f++}else if(S.isHemisphereLight){let R=i.hemi[p];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:i}}function Pv(n){let e=new PA(n),t=[],i=[],s=[];function r(d){u.camera=d,t.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):t.push(d)}function a(d){i.push(d)}function l(){e.setup(t),s.sort((d,h)=>d.priority-h.priority||d.id-h.id)}function c(d){e.setupView(t,d)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function IA(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Pv(n),e.set(s,[a])):r>=o.length?(a=new Pv(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var LA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,DA=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,NA=[new O(1,0,0),new O(-1,0,0),new O(0,1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1)],FA=[new O(0,-1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1),new O(0,-1,0),new O(0,-1,0)],Iv=new Mt,xl=new O,gp=new O;function UA(n,e,t){let i=new fr,s=new ct,r=new ct,o=new an,a=new Eu,l=new Tu,c={},u=t.maxTextureSize,d={[xs]:mi,[mi]:xs,[ii]:ii},h=new vs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ct},radius:{value:4}},vertexShader:LA,fragmentShader:DA}),f=h.clone();f.defines.HORIZONTAL_PASS=1;let g=new Nt;g.setAttribute("position",new Zn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Le(g,h),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=cl;let m=this.type;this.render=function(C,v,w){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||C.length===0)return;this.type===E_&&(Je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=cl);let U=n.getRenderTarget(),I=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),z=n.state;z.setBlending(Yr),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let G=m!==this.type;G&&v.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=C.length;N<W;N++){let $=C[N],H=$.shadow;if(H===void 0){Je("WebGLShadowMap:",$,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let le=H.getFrameExtents();s.multiply(le),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,H.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=Y,H.map===null||G===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===na){if($.isPointLight){Je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new Ii(s.x,s.y,{format:br,type:ns,minFilter:pi,magFilter:pi,generateMipmaps:!1}),H.map.texture.name=$.name+".shadowMap",H.map.depthTexture=new Vs(s.x,s.y,ts),H.map.depthTexture.name=$.name+".shadowMapDepth",H.map.depthTexture.format=zs,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Ln,H.map.depthTexture.magFilter=Ln}else $.isPointLight?(H.map=new bl(s.x),H.map.depthTexture=new Ja(s.x,es)):(H.map=new Ii(s.x,s.y),H.map.depthTexture=new Vs(s.x,s.y,es)),H.map.depthTexture.name=$.name+".shadowMap",H.map.depthTexture.format=zs,this.type===cl?(H.map.depthTexture.compareFunction=Y?ap:op,H.map.depthTexture.minFilter=pi,H.map.depthTexture.magFilter=pi):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Ln,H.map.depthTexture.magFilter=Ln);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let j=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();$.isPointLight!==!0&&H.updateMatrices($,w);let ie=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:w.layers;for(let he=0;he<j;he++){let de=H.getCamera(he);if($.isPointLight){let ee=H.camera,me=H.matrix,ve=$.distance||ee.far;ve!==ee.far&&(ee.far=ve,ee.updateProjectionMatrix()),xl.setFromMatrixPosition($.matrixWorld),ee.position.copy(xl),gp.copy(ee.position),gp.add(NA[he]),ee.up.copy(FA[he]),ee.lookAt(gp),ee.updateMatrixWorld(),me.makeTranslation(-xl.x,-xl.y,-xl.z),Iv.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Iv,ee.coordinateSystem,ee.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,he),n.clear();else{he===0&&(n.setRenderTarget(H.map),n.clear());let ee=H.getViewport(he);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),z.viewport(o)}i=H.getFrustum(he),S(v,w,de,$,ie,this.type)}H.isPointLightShadow!==!0&&this.type===na&&x(H,w),H.needsUpdate=!1}m=this.type,p.needsUpdate=!1,n.setRenderTarget(U,I,D)};function x(C,v){let w=e.update(y);h.defines.VSM_SAMPLES!==C.blurSamples&&(h.defines.VSM_SAMPLES=C.blurSamples,f.defines.VSM_SAMPLES=C.blurSamples,h.needsUpdate=!0,f.needsUpdate=!0),C.mapPass===null?C.mapPass=new Ii(s.x,s.y,{format:br,type:ns}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),h.uniforms.shadow_pass.value=C.map.depthTexture,h.uniforms.resolution.value.set(C.map.width,C.map.height),h.uniforms.radius.value=C.radius,n.setRenderTarget(C.mapPass),n.clear(),n.renderBufferDirect(v,null,w,h,y,null),f.uniforms.shadow_pass.value=C.mapPass.texture,f.uniforms.resolution.value.set(C.map.width,C.map.height),f.uniforms.radius.value=C.radius,n.setRenderTarget(C.map),n.clear(),n.renderBufferDirect(v,null,w,f,y,null)}function E(C,v,w,U){let I=null,D=w.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(D!==void 0)I=D;else if(I=w.isPointLight===!0?l:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let z=I.uuid,G=v.uuid,N=c[z];N===void 0&&(N={},c[z]=N);let W=N[G];W===void 0&&(W=I.clone(),N[G]=W,v.addEventListener("dispose",R)),I=W}if(I.visible=v.visible,I.wireframe=v.wireframe,U===na?I.side=v.shadowSide!==null?v.shadowSide:v.side:I.side=v.shadowSide!==null?v.shadowSide:d[v.side],I.alphaMap=v.alphaMap,I.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,I.map=v.map,I.clipShadows=v.clipShadows,I.clippingPlanes=v.clippingPlanes,I.clipIntersection=v.clipIntersection,I.displacementMap=v.displacementMap,I.displacementScale=v.displacementScale,I.displacementBias=v.displacementBias,I.wireframeLinewidth=v.wireframeLinewidth,I.linewidth=v.linewidth,w.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let z=n.properties.get(I);z.light=w}return I}function S(C,v,w,U,I,D){if(C.visible===!1)return;if(C.layers.test(I)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&D===na)&&(!C.frustumCulled||C.intersectsFrustum(i))){C.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,C.matrixWorld);let N=e.update(C),W=C.material;if(Array.isArray(W)){let $=N.groups;for(let H=0,le=$.length;H<le;H++){let Y=$[H],j=W[Y.materialIndex];if(j&&j.visible){let ie=E(C,j,U,D);C.onBeforeShadow(n,C,v,w,N,ie,Y),n.renderBufferDirect(w,null,N,ie,C,Y),C.onAfterShadow(n,C,v,w,N,ie,Y)}}}else if(W.visible){let $=E(C,W,U,D);C.onBeforeShadow(n,C,v,w,N,$,null),n.renderBufferDirect(w,null,N,$,C,null),C.onAfterShadow(n,C,v,w,N,$,null)}}let G=C.children;for(let N=0,W=G.length;N<W;N++)S(G[N],v,w,U,I,D)}function R(C){C.target.removeEventListener("dispose",R);for(let w in c){let U=c[w],I=C.target.uuid;I in U&&(U[I].dispose(),delete U[I])}}}function OA(n,e){function t(){let k=!1,re=new an,ne=null,we=new an(0,0,0,0);return{setMask:function(ge){ne!==ge&&!k&&(n.colorMask(ge,ge,ge,ge),ne=ge)},setLocked:function(ge){k=ge},setClear:function(ge,be,qe,je,ce){ce===!0&&(ge*=je,be*=je,qe*=je),re.set(ge,be,qe,je),we.equals(re)===!1&&(n.clearColor(ge,be,qe,je),we.copy(re))},reset:function(){k=!1,ne=null,we.set(-1,0,0,0)}}}function i(){let k=!1,re=!1,ne=null,we=null,ge=null;return{setReversed:function(be){if(re!==be){let qe=e.get("EXT_clip_control");be?qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.ZERO_TO_ONE_EXT):qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.NEGATIVE_ONE_TO_ONE_EXT),re=be;let je=ge;ge=null,this.setClear(je)}},getReversed:function(){return re},setTest:function(be){be?Se(n.DEPTH_TEST):Ye(n.DEPTH_TEST)},setMask:function(be){ne!==be&&!k&&(n.depthMask(be),ne=be)},setFunc:function(be){if(re&&(be=rv[be]),we!==be){switch(be){case au:n.depthFunc(n.NEVER);break;case lu:n.depthFunc(n.ALWAYS);break;case cu:n.depthFunc(n.LESS);break;case Yo:n.depthFunc(n.LEQUAL);break;case uu:n.depthFunc(n.EQUAL);break;case hu:n.depthFunc(n.GEQUAL);break;case du:n.depthFunc(n.GREATER);break;case fu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}we=be}},setLocked:function(be){k=be},setClear:function(be){ge!==be&&(ge=be,re&&(be=1-be),n.clearDepth(be))},reset:function(){k=!1,ne=null,we=null,ge=null,re=!1}}}function s(){let k=!1,re=null,ne=null,we=null,ge=null,be=null,qe=null,je=null,ce=null;return{setTest:function(Be){k||(Be?Se(n.STENCIL_TEST):Ye(n.STENCIL_TEST))},setMask:function(Be){re!==Be&&!k&&(n.stencilMask(Be),re=Be)},setFunc:function(Be,et,Re){(ne!==Be||we!==et||ge!==Re)&&(n.stencilFunc(Be,et,Re),ne=Be,we=et,ge=Re)},setOp:function(Be,et,Re){(be!==Be||qe!==et||je!==Re)&&(n.stencilOp(Be,et,Re),be=Be,qe=et,je=Re)},setLocked:function(Be){k=Be},setClear:function(Be){ce!==Be&&(n.clearStencil(Be),ce=Be)},reset:function(){k=!1,re=null,ne=null,we=null,ge=null,be=null,qe=null,je=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},d={},h={},f=new WeakMap,g=[],y=null,p=!1,m=null,x=null,E=null,S=null,R=null,C=null,v=null,w=new st(0,0,0),U=0,I=!1,D=null,z=null,G=null,N=null,W=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,le=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(Y)[1]),H=le>=1):Y.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),H=le>=2);let j=null,ie={},he=n.getParameter(n.SCISSOR_BOX),de=n.getParameter(n.VIEWPORT),ee=new an().fromArray(he),me=new an().fromArray(de);function ve(k,re,ne,we){let ge=new Uint8Array(4),be=n.createTexture();n.bindTexture(k,be),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let qe=0;qe<ne;qe++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,we,0,n.RGBA,n.UNSIGNED_BYTE,ge):n.texImage2D(re+qe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ge);return be}let Ce={};Ce[n.TEXTURE_2D]=ve(n.TEXTURE_2D,n.TEXTURE_2D,1),Ce[n.TEXTURE_CUBE_MAP]=ve(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ce[n.TEXTURE_2D_ARRAY]=ve(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ce[n.TEXTURE_3D]=ve(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Se(n.DEPTH_TEST),o.setFunc(Yo),Mn(!1),zt(Bf),Se(n.CULL_FACE),sn(Yr);function Se(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function Ye(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function at(k,re){return h[k]!==re?(n.bindFramebuffer(k,re),h[k]=re,k===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=re),k===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Xe(k,re){let ne=g,we=!1;if(k){ne=f.get(re),ne===void 0&&(ne=[],f.set(re,ne));let ge=k.textures;if(ne.length!==ge.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let be=0,qe=ge.length;be<qe;be++)ne[be]=n.COLOR_ATTACHMENT0+be;ne.length=ge.length,we=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,we=!0);we&&n.drawBuffers(ne)}function pt(k){return y!==k?(n.useProgram(k),y=k,!0):!1}let ht={[$r]:n.FUNC_ADD,[A_]:n.FUNC_SUBTRACT,[C_]:n.FUNC_REVERSE_SUBTRACT};ht[R_]=n.MIN,ht[P_]=n.MAX;let rt={[I_]:n.ZERO,[L_]:n.ONE,[D_]:n.SRC_COLOR,[Hf]:n.SRC_ALPHA,[B_]:n.SRC_ALPHA_SATURATE,[O_]:n.DST_COLOR,[F_]:n.DST_ALPHA,[N_]:n.ONE_MINUS_SRC_COLOR,[Wf]:n.ONE_MINUS_SRC_ALPHA,[k_]:n.ONE_MINUS_DST_COLOR,[U_]:n.ONE_MINUS_DST_ALPHA,[z_]:n.CONSTANT_COLOR,[V_]:n.ONE_MINUS_CONSTANT_COLOR,[G_]:n.CONSTANT_ALPHA,[H_]:n.ONE_MINUS_CONSTANT_ALPHA};function sn(k,re,ne,we,ge,be,qe,je,ce,Be){if(k===Yr){p===!0&&(Ye(n.BLEND),p=!1);return}if(p===!1&&(Se(n.BLEND),p=!0),k!==T_){if(k!==m||Be!==I){if((x!==$r||R!==$r)&&(n.blendEquation(n.FUNC_ADD),x=$r,R=$r),Be)switch(k){case ia:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case zf:n.blendFunc(n.ONE,n.ONE);break;case Vf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Gf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:tt("WebGLState: Invalid blending: ",k);break}else switch(k){case ia:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case zf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Vf:tt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Gf:tt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:tt("WebGLState: Invalid blending: ",k);break}E=null,S=null,C=null,v=null,w.set(0,0,0),U=0,m=k,I=Be}return}ge=ge||re,be=be||ne,qe=qe||we,(re!==x||ge!==R)&&(n.blendEquationSeparate(ht[re],ht[ge]),x=re,R=ge),(ne!==E||we!==S||be!==C||qe!==v)&&(n.blendFuncSeparate(rt[ne],rt[we],rt[be],rt[qe]),E=ne,S=we,C=be,v=qe),(je.equals(w)===!1||ce!==U)&&(n.blendColor(je.r,je.g,je.b,ce),w.copy(je),U=ce),m=k,I=!1}function Yt(k,re){k.side===ii?Ye(n.CULL_FACE):Se(n.CULL_FACE);let ne=k.side===mi;re&&(ne=!ne),Mn(ne),k.blending===ia&&k.transparent===!1?sn(Yr):sn(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let we=k.stencilWrite;a.setTest(we),we&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),Et(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?Se(n.SAMPLE_ALPHA_TO_COVERAGE):Ye(n.SAMPLE_ALPHA_TO_COVERAGE)}function Mn(k){D!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),D=k)}function zt(k){k!==M_?(Se(n.CULL_FACE),k!==z&&(k===Bf?n.cullFace(n.BACK):k===w_?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ye(n.CULL_FACE),z=k}function zn(k){k!==G&&(H&&n.lineWidth(k),G=k)}function Et(k,re,ne){k?(Se(n.POLYGON_OFFSET_FILL),(N!==re||W!==ne)&&(N=re,W=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):Ye(n.POLYGON_OFFSET_FILL)}function Dn(k){k?Se(n.SCISSOR_TEST):Ye(n.SCISSOR_TEST)}function dn(k){k===void 0&&(k=n.TEXTURE0+$-1),j!==k&&(n.activeTexture(k),j=k)}function wn(k,re,ne){ne===void 0&&(j===null?ne=n.TEXTURE0+$-1:ne=j);let we=ie[ne];we===void 0&&(we={type:void 0,texture:void 0},ie[ne]=we),(we.type!==k||we.texture!==re)&&(j!==ne&&(n.activeTexture(ne),j=ne),n.bindTexture(k,re||Ce[k]),we.type=k,we.texture=re)}function B(){let k=ie[j];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Pe(){try{n.compressedTexImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function Ke(){try{n.compressedTexImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function lt(){try{n.texSubImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function Me(){try{n.texSubImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function Gt(){try{n.compressedTexSubImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function We(){try{n.compressedTexSubImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function Ze(){try{n.texStorage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function P(){try{n.texStorage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function M(){try{n.texImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function q(){try{n.texImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function ue(k){return d[k]!==void 0?d[k]:n.getParameter(k)}function oe(k,re){d[k]!==re&&(n.pixelStorei(k,re),d[k]=re)}function _e(k){ee.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),ee.copy(k))}function xe(k){me.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),me.copy(k))}function te(k,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let we=ne.get(k);we===void 0&&(we=n.getUniformBlockIndex(re,k.name),n.uniformBlockBinding(re,we,we),ne.set(k,we))}function se(k,re,ne){let ge=c.get(re).get(k);l[ge]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,ge,ne),l[ge]=ne)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},d={},j=null,ie={},h={},l={},f=new WeakMap,g=[],y=null,p=!1,m=null,x=null,E=null,S=null,R=null,C=null,v=null,w=new st(0,0,0),U=0,I=!1,D=null,z=null,G=null,N=null,W=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Se,disable:Ye,bindFramebuffer:at,drawBuffers:Xe,useProgram:pt,setBlending:sn,setMaterial:Yt,setFlipSided:Mn,setCullFace:zt,setLineWidth:zn,setPolygonOffset:Et,setScissorTest:Dn,activeTexture:dn,bindTexture:wn,unbindTexture:B,compressedTexImage2D:Pe,compressedTexImage3D:Ke,texImage2D:M,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:Ze,texStorage3D:P,texSubImage2D:lt,texSubImage3D:Me,compressedTexSubImage2D:Gt,compressedTexSubImage3D:We,scissor:_e,viewport:xe,reset:pe}}function kA(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ct,u=new WeakMap,d=new Set,h,f=new WeakMap,g=new Set,y=new FinalizationRegistry(P=>g.delete(P)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(P,M){return p?new OffscreenCanvas(P,M):Wa("canvas")}function x(P,M,q){let ue=1,oe=Ze(P);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let _e=Math.floor(ue*oe.width),xe=Math.floor(ue*oe.height);h===void 0&&(h=m(_e,xe));let te=M?m(_e,xe):h;return te.width=_e,te.height=xe,te.getContext("2d").drawImage(P,0,0,_e,xe),Je("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+_e+"x"+xe+")."),te}else return"data"in P&&Je("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),P;return P}function E(P){return P.generateMipmaps}function S(P){n.generateMipmap(P)}function R(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function C(P,M,q,ue,oe,_e=!1){if(P!==null){if(n[P]!==void 0)return n[P];Je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let xe;ue&&(xe=e.get("EXT_texture_norm16"),xe||Je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=M;if(M===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&xe&&(te=xe.R16_EXT),q===n.SHORT&&xe&&(te=xe.R16_SNORM_EXT)),M===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),M===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&xe&&(te=xe.RG16_EXT),q===n.SHORT&&xe&&(te=xe.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),M===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),M===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),M===n.RGB&&(q===n.UNSIGNED_SHORT&&xe&&(te=xe.RGB16_EXT),q===n.SHORT&&xe&&(te=xe.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),M===n.RGBA){let se=_e?Ha:St.getTransfer(oe);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=se===Dt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&xe&&(te=xe.RGBA16_EXT),q===n.SHORT&&xe&&(te=xe.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(P,M){let q;return P?M===null||M===es||M===Kr?q=n.DEPTH24_STENCIL8:M===ts?q=n.DEPTH32F_STENCIL8:M===yr&&(q=n.DEPTH24_STENCIL8,Je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===es||M===Kr?q=n.DEPTH_COMPONENT24:M===ts?q=n.DEPTH_COMPONENT32F:M===yr&&(q=n.DEPTH_COMPONENT16),q}function w(P,M){return E(P)===!0||P.isFramebufferTexture&&P.minFilter!==Ln&&P.minFilter!==pi?Math.log2(Math.max(M.width,M.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?M.mipmaps.length:1}function U(P){let M=new WeakRef(P);i.get(P).__ref=M,g.add(M),y.register(P,M,M)}function I(P){let M=i.get(P).__ref;M!==void 0&&(g.delete(M),y.unregister(M))}function D(P){G(P.target)}function z(P){N(P.target)}function G(P){P.removeEventListener("dispose",D),I(P),$(P),P.isVideoTexture&&u.delete(P),P.isHTMLTexture&&d.delete(P)}function N(P){P.removeEventListener("dispose",z),I(P),le(P)}function W(){for(let P of g){let M=P.deref();M!==void 0&&(M.isRenderTarget===!0?N(M):G(M))}g.clear(),d.clear()}function $(P){let M=i.get(P);if(M.__webglInit===void 0)return;let q=P.source,ue=f.get(q);if(ue){let oe=ue[M.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&H(P),Object.keys(ue).length===0&&f.delete(q)}i.remove(P)}function H(P){let M=i.get(P);n.deleteTexture(M.__webglTexture);let q=P.source,ue=f.get(q);delete ue[M.__cacheKey],o.memory.textures--}function le(P){let M=i.get(P);M.__depthDisposeCallback&&M.__depthDisposeCallback();let q=P.depthTexture;if(q&&q.renderTarget===P&&G(q),P.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(M.__webglFramebuffer[oe]))for(let _e=0;_e<M.__webglFramebuffer[oe].length;_e++)n.deleteFramebuffer(M.__webglFramebuffer[oe][_e]);else n.deleteFramebuffer(M.__webglFramebuffer[oe]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[oe])}else{if(Array.isArray(M.__webglFramebuffer))for(let oe=0;oe<M.__webglFramebuffer.length;oe++)n.deleteFramebuffer(M.__webglFramebuffer[oe]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let oe=0;oe<M.__webglColorRenderbuffer.length;oe++)M.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[oe]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=P.textures;for(let oe=0,_e=ue.length;oe<_e;oe++){let xe=i.get(ue[oe]);xe.__webglTexture&&(n.deleteTexture(xe.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(P)}let Y=0;function j(){Y=0}function ie(){return Y}function he(P){Y=P}function de(){let P=Y;return P>=s.maxTextures&&Je("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,P}function ee(P){let M=[];return M.push(P.wrapS),M.push(P.wrapT),M.push(P.wrapR||0),M.push(P.magFilter),M.push(P.minFilter),M.push(P.anisotropy),M.push(P.internalFormat),M.push(P.format),M.push(P.type),M.push(P.generateMipmaps),M.push(P.mipmapsAutoUpdate),M.push(P.premultiplyAlpha),M.push(P.flipY),M.push(P.unpackAlignment),M.push(P.colorSpace),M.join()}function me(P,M){let q=i.get(P);if(P.isVideoTexture&&Gt(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&q.__version!==P.version){let ue=P.image;if(ue===null)Je("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Je("WebGLRenderer: Texture marked for update but image is incomplete");else{Yt(q,P,M);return}}else P.isExternalTexture&&(q.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+M)}function ve(P,M){let q=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&q.__version!==P.version){Yt(q,P,M);return}else P.isExternalTexture&&(q.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+M)}function Ce(P,M){let q=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&q.__version!==P.version){Yt(q,P,M);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+M)}function Se(P,M){let q=i.get(P);if(P.version>0&&q.__version!==P.version){Mn(q,P,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+M)}let Ye={[pu]:n.REPEAT,[ms]:n.CLAMP_TO_EDGE,[mu]:n.MIRRORED_REPEAT},at={[Ln]:n.NEAREST,[q_]:n.NEAREST_MIPMAP_NEAREST,[ul]:n.NEAREST_MIPMAP_LINEAR,[pi]:n.LINEAR,[Gu]:n.LINEAR_MIPMAP_NEAREST,[Hs]:n.LINEAR_MIPMAP_LINEAR},Xe={[K_]:n.NEVER,[lp]:n.ALWAYS,[J_]:n.LESS,[op]:n.LEQUAL,[Q_]:n.EQUAL,[ap]:n.GEQUAL,[j_]:n.GREATER,[ev]:n.NOTEQUAL};function pt(P,M){if(M.type===ts&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===pi||M.magFilter===Gu||M.magFilter===ul||M.magFilter===Hs||M.minFilter===pi||M.minFilter===Gu||M.minFilter===ul||M.minFilter===Hs)&&Je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,Ye[M.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,Ye[M.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,Ye[M.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,at[M.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,at[M.minFilter]),M.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,Xe[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Ln||M.minFilter!==ul&&M.minFilter!==Hs||M.type===ts&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(P,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ht(P,M){let q=!1;P.__webglInit===void 0&&(P.__webglInit=!0,M.addEventListener("dispose",D),U(M));let ue=M.source,oe=f.get(ue);oe===void 0&&(oe={},f.set(ue,oe));let _e=ee(M);if(_e!==P.__cacheKey){oe[_e]===void 0&&(oe[_e]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[_e].usedTimes++;let xe=oe[P.__cacheKey];xe!==void 0&&(oe[P.__cacheKey].usedTimes--,xe.usedTimes===0&&H(M)),P.__cacheKey=_e,P.__webglTexture=oe[_e].texture}return q}function rt(P,M,q){return Math.floor(Math.floor(P/q)/M)}function sn(P,M,q,ue){let _e=P.updateRanges;if(_e.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,q,ue,M.data);else{_e.sort((k,re)=>k.start-re.start);let xe=0;for(let k=1;k<_e.length;k++){let re=_e[xe],ne=_e[k],we=re.start+re.count,ge=rt(ne.start,M.width,4),be=rt(re.start,M.width,4);ne.start<=we+1&&ge===be&&rt(ne.start+ne.count-1,M.width,4)===ge?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++xe,_e[xe]=ne)}_e.length=xe+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let k=0,re=_e.length;k<re;k++){let ne=_e[k],we=Math.floor(ne.start/4),ge=Math.ceil(ne.count/4),be=we%M.width,qe=Math.floor(we/M.width),je=ge,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,be),t.pixelStorei(n.UNPACK_SKIP_ROWS,qe),t.texSubImage2D(n.TEXTURE_2D,0,be,qe,je,ce,q,ue,M.data)}P.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Yt(P,M,q){let ue=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=ht(P,M),_e=M.source;t.bindTexture(ue,P.__webglTexture,n.TEXTURE0+q);let xe=i.get(_e);if(_e.version!==xe.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ce=St.getPrimaries(St.workingColorSpace),Be=M.colorSpace===Xs?null:St.getPrimaries(M.colorSpace),et=M.colorSpace===Xs||ce===Be?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let se=x(M.image,!1,s.maxTextureSize);se=We(M,se);let pe=r.convert(M.format,M.colorSpace),k=r.convert(M.type),re=C(M.internalFormat,pe,k,M.normalized,M.colorSpace,M.isVideoTexture);pt(ue,M);let ne,we=M.mipmaps,ge=M.isVideoTexture!==!0,be=xe.__version===void 0||oe===!0,qe=_e.dataReady,je=w(M,se);if(M.isDepthTexture)re=v(M.format===Ws,M.type),be&&(ge?t.texStorage2D(n.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,k,null));else if(M.isDataTexture)if(we.length>0){ge&&be&&t.texStorage2D(n.TEXTURE_2D,je,re,we[0].width,we[0].height);for(let ce=0,Be=we.length;ce<Be;ce++)ne=we[ce],ge?qe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,k,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,k,ne.data);M.generateMipmaps=!1}else ge?(be&&t.texStorage2D(n.TEXTURE_2D,je,re,se.width,se.height),qe&&sn(M,se,pe,k)):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,k,se.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){ge&&be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,re,we[0].width,we[0].height,se.depth);for(let ce=0,Be=we.length;ce<Be;ce++)if(ne=we[ce],M.format!==Di)if(pe!==null)if(ge){if(qe)if(M.layerUpdates.size>0){let et=pp(ne.width,ne.height,M.format,M.type);for(let Re of M.layerUpdates){let ut=ne.data.subarray(Re*et/ne.data.BYTES_PER_ELEMENT,(Re+1)*et/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Re,ne.width,ne.height,1,pe,ut)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?qe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,k,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,pe,k,ne.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{ge&&be&&t.texStorage2D(n.TEXTURE_2D,je,re,we[0].width,we[0].height);for(let ce=0,Be=we.length;ce<Be;ce++)ne=we[ce],M.format!==Di?pe!==null?ge?qe&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?qe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,k,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,k,ne.data)}else if(M.isDataArrayTexture)if(ge){if(be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,re,se.width,se.height,se.depth),qe)if(M.layerUpdates.size>0){let ce=pp(se.width,se.height,M.format,M.type);for(let Be of M.layerUpdates){let et=se.data.subarray(Be*ce/se.data.BYTES_PER_ELEMENT,(Be+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Be,se.width,se.height,1,pe,k,et)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,k,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,pe,k,se.data);else if(M.isData3DTexture)ge?(be&&t.texStorage3D(n.TEXTURE_3D,je,re,se.width,se.height,se.depth),qe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,k,se.data)):t.texImage3D(n.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,pe,k,se.data);else if(M.isFramebufferTexture){if(be)if(ge)t.texStorage2D(n.TEXTURE_2D,je,re,se.width,se.height);else{let ce=se.width,Be=se.height;for(let et=0;et<je;et++)t.texImage2D(n.TEXTURE_2D,et,re,ce,Be,0,pe,k,null),ce>>=1,Be>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),d.add(M),ce.onpaint=Be=>{let et=Be.changedElements;for(let Re of d)et.includes(Re.image)&&(Re.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let et=n.RGBA,Re=n.RGBA,ut=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,et,Re,ut,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(we.length>0){if(ge&&be){let ce=Ze(we[0]);t.texStorage2D(n.TEXTURE_2D,je,re,ce.width,ce.height)}for(let ce=0,Be=we.length;ce<Be;ce++)ne=we[ce],ge?qe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,k,ne):t.texImage2D(n.TEXTURE_2D,ce,re,pe,k,ne);M.generateMipmaps=!1}else if(ge){if(be){let ce=Ze(se);t.texStorage2D(n.TEXTURE_2D,je,re,ce.width,ce.height)}qe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,k,se)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,k,se);E(M)&&M.mipmapsAutoUpdate===!0&&S(ue),xe.__version=_e.version,M.onUpdate&&M.onUpdate(M)}P.__version=M.version}function Mn(P,M,q){if(M.image.length!==6)return;let ue=ht(P,M),oe=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+q);let _e=i.get(oe);if(oe.version!==_e.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let xe=St.getPrimaries(St.workingColorSpace),te=M.colorSpace===Xs?null:St.getPrimaries(M.colorSpace),se=M.colorSpace===Xs||xe===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=M.isCompressedTexture||M.image[0].isCompressedTexture,k=M.image[0]&&M.image[0].isDataTexture,re=[];for(let Re=0;Re<6;Re++)!pe&&!k?re[Re]=x(M.image[Re],!0,s.maxCubemapSize):re[Re]=k?M.image[Re].image:M.image[Re],re[Re]=We(M,re[Re]);let ne=re[0],we=r.convert(M.format,M.colorSpace),ge=r.convert(M.type),be=C(M.internalFormat,we,ge,M.normalized,M.colorSpace),qe=M.isVideoTexture!==!0,je=_e.__version===void 0||ue===!0,ce=oe.dataReady,Be=w(M,ne);pt(n.TEXTURE_CUBE_MAP,M);let et;if(M.isDepthTexture){if(be=v(M.format===Ws,M.type),je)if(qe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,be,ne.width,ne.height);else for(let Re=0;Re<6;Re++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,ne.width,ne.height,0,we,ge,null)}else if(pe){qe&&je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,be,ne.width,ne.height);for(let Re=0;Re<6;Re++){et=re[Re].mipmaps;for(let ut=0;ut<et.length;ut++){let Kt=et[ut];M.format!==Di?we!==null?qe?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut,0,0,Kt.width,Kt.height,we,Kt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut,be,Kt.width,Kt.height,0,Kt.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut,0,0,Kt.width,Kt.height,we,ge,Kt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut,be,Kt.width,Kt.height,0,we,ge,Kt.data)}}}else{if(et=M.mipmaps,qe&&je){et.length>0&&Be++;let Re=Ze(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,be,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(k){qe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,re[Re].width,re[Re].height,we,ge,re[Re].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,re[Re].width,re[Re].height,0,we,ge,re[Re].data);for(let ut=0;ut<et.length;ut++){let ri=et[ut].image[Re].image;qe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut+1,0,0,ri.width,ri.height,we,ge,ri.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut+1,be,ri.width,ri.height,0,we,ge,ri.data)}}else{qe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,we,ge,re[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,we,ge,re[Re]);for(let ut=0;ut<et.length;ut++){let Kt=et[ut];qe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut+1,0,0,we,ge,Kt.image[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut+1,be,we,ge,Kt.image[Re])}}}E(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),_e.__version=oe.version,M.onUpdate&&M.onUpdate(M)}P.__version=M.version}function zt(P,M,q,ue,oe,_e){let xe=r.convert(q.format,q.colorSpace),te=r.convert(q.type),se=C(q.internalFormat,xe,te,q.normalized,q.colorSpace),pe=i.get(M),k=i.get(q);if(k.__renderTarget=M,!pe.__hasExternalTextures){let re=Math.max(1,M.width>>_e),ne=Math.max(1,M.height>>_e);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,_e,se,re,ne,M.depth,0,xe,te,null):t.texImage2D(oe,_e,se,re,ne,0,xe,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,P),Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,k.__webglTexture,0,lt(M)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,k.__webglTexture,_e),t.bindFramebuffer(n.FRAMEBUFFER,null)}function zn(P,M,q){if(n.bindRenderbuffer(n.RENDERBUFFER,P),M.depthBuffer){let ue=M.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,_e=v(M.stencilBuffer,oe),xe=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(M),_e,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(M),_e,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,_e,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,xe,n.RENDERBUFFER,P)}else{let ue=M.textures;for(let oe=0;oe<ue.length;oe++){let _e=ue[oe],xe=r.convert(_e.format,_e.colorSpace),te=r.convert(_e.type),se=C(_e.internalFormat,xe,te,_e.normalized,_e.colorSpace);Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(M),se,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(M),se,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,se,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Et(P,M,q){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,P),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(M.depthTexture);oe.__renderTarget=M;let _e=ue?M.depthTexture.image[0]:M.depthTexture.image;(!oe.__webglTexture||_e.width!==M.width||_e.height!==M.height)&&(_e.width=M.width,_e.height=M.height,M.depthTexture.needsUpdate=!0),ue?Se(M.depthTexture,0):me(M.depthTexture,0);let xe=oe.__webglTexture,te=lt(M),se=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,pe=M.depthTexture.format===Ws?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===zs)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,xe,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,xe,0);else if(M.depthTexture.format===Ws)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,xe,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,xe,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Dn(P){let M=i.get(P),q=P.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==P.depthTexture){let ue=P.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let oe=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),M.__depthDisposeCallback=oe}M.__boundDepthTexture=ue}if(P.depthTexture&&!M.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)Et(M.__webglFramebuffer[ue],P,ue);else P.texture.mipmaps.length>0?Et(M.__webglFramebuffer[0],P,0):Et(M.__webglFramebuffer,P,0);else if(q){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=n.createRenderbuffer(),zn(M.__webglDepthbuffer[ue],P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,_e)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),zn(M.__webglDepthbuffer,P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,_e)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function dn(P,M,q){let ue=i.get(P);M!==void 0&&zt(ue.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&Dn(P)}function wn(P){let M=P.texture,q=i.get(P),ue=i.get(M);P.addEventListener("dispose",z),U(P);let oe=P.textures,_e=P.isWebGLCubeRenderTarget===!0,xe=oe.length>1;if(xe||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=M.version,o.memory.textures++),_e){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(M.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let se=0;se<M.mipmaps.length;se++)q.__webglFramebuffer[te][se]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(M.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<M.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(xe)for(let te=0,se=oe.length;te<se;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&Me(P)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let se=oe[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let pe=r.convert(se.format,se.colorSpace),k=r.convert(se.type),re=C(se.internalFormat,pe,k,se.normalized,se.colorSpace,P.isXRRenderTarget===!0),ne=lt(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),zn(q.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_e){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),pt(n.TEXTURE_CUBE_MAP,M);for(let te=0;te<6;te++)if(M.mipmaps.length>0)for(let se=0;se<M.mipmaps.length;se++)zt(q.__webglFramebuffer[te][se],P,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else zt(q.__webglFramebuffer[te],P,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);E(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(xe){for(let te=0,se=oe.length;te<se;te++){let pe=oe[te],k=i.get(pe),re=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(re=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,k.__webglTexture),pt(re,pe),zt(q.__webglFramebuffer,P,pe,n.COLOR_ATTACHMENT0+te,re,0),E(pe)&&S(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(te=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),pt(te,M),M.mipmaps.length>0)for(let se=0;se<M.mipmaps.length;se++)zt(q.__webglFramebuffer[se],P,M,n.COLOR_ATTACHMENT0,te,se);else zt(q.__webglFramebuffer,P,M,n.COLOR_ATTACHMENT0,te,0);E(M)?S(te):M.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&Dn(P)}function B(P){let M=P.textures;for(let q=0,ue=M.length;q<ue;q++){let oe=M[q];if(E(oe)&&oe.mipmapsAutoUpdate===!0){let _e=R(P),xe=i.get(oe).__webglTexture;t.bindTexture(_e,xe),S(_e),t.unbindTexture()}}}let Pe=[];function Ke(P){if(P.samples>0){if(Me(P)===!1){let M=P.textures,q=P.width,ue=P.height,oe=n.COLOR_BUFFER_BIT,_e=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=i.get(P),te=M.length>1;if(te)for(let pe=0;pe<M.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,xe.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,xe.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,xe.__webglFramebuffer);for(let pe=0;pe<M.length;pe++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,xe.__webglColorRenderbuffer[pe]);let k=i.get(M[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,n.NEAREST),l===!0&&(Pe.length=0,Pe.push(n.COLOR_ATTACHMENT0+pe),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Pe.push(_e),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<M.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,xe.__webglColorRenderbuffer[pe]);let k=i.get(M[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,k,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,xe.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let M=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function lt(P){return Math.min(s.maxSamples,P.samples)}function Me(P){let M=i.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Gt(P){let M=o.render.frame;u.get(P)!==M&&(u.set(P,M),P.update())}function We(P,M){let q=P.colorSpace,ue=P.format,oe=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||q!==Ga&&q!==Xs&&(St.getTransfer(q)===Dt?(ue!==Di||oe!==Kn)&&Je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):tt("WebGLTextures: Unsupported texture color space:",q)),M}function Ze(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=de,this.resetTextureUnits=j,this.getTextureUnits=ie,this.setTextureUnits=he,this.setTexture2D=me,this.setTexture2DArray=ve,this.setTexture3D=Ce,this.setTextureCube=Se,this.rebindTextures=dn,this.setupRenderTarget=wn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Ke,this.setupDepthRenderbuffer=Dn,this.setupFrameBufferTexture=zt,this.useMultisampledRTT=Me,this.dispose=W}function BA(n,e){function t(i,s=Xs){let r,o=St.getTransfer(s);if(i===Kn)return n.UNSIGNED_BYTE;if(i===Wu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Xu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===tp)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===np)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===jf)return n.BYTE;if(i===ep)return n.SHORT;if(i===yr)return n.UNSIGNED_SHORT;if(i===Hu)return n.INT;if(i===es)return n.UNSIGNED_INT;if(i===ts)return n.FLOAT;if(i===ns)return n.HALF_FLOAT;if(i===ip)return n.ALPHA;if(i===sp)return n.RGB;if(i===Di)return n.RGBA;if(i===zs)return n.DEPTH_COMPONENT;if(i===Ws)return n.DEPTH_STENCIL;if(i===rp)return n.RED;if(i===ra)return n.RED_INTEGER;if(i===br)return n.RG;if(i===qu)return n.RG_INTEGER;if(i===Yu)return n.RGBA_INTEGER;if(i===hl||i===dl||i===fl||i===pl)if(o===Dt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===hl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===dl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===fl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===pl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===hl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===dl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===fl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===pl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===$u||i===Zu||i===Ku||i===Ju)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===$u)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Zu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Ku)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Ju)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Qu||i===ju||i===eh||i===th||i===nh||i===ml||i===ih)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Qu||i===ju)return o===Dt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===eh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===th)return r.COMPRESSED_R11_EAC;if(i===nh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===ml)return r.COMPRESSED_RG11_EAC;if(i===ih)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===sh||i===rh||i===oh||i===ah||i===lh||i===ch||i===uh||i===hh||i===dh||i===fh||i===ph||i===mh||i===gh||i===_h)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===sh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===rh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===oh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===ah)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===lh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===ch)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===uh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===hh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===dh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===fh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===ph)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===mh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===gh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===_h)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===vh||i===xh||i===yh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===vh)return o===Dt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===xh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===yh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===bh||i===Sh||i===gl||i===Mh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===bh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Sh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===gl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Mh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Kr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var zA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,VA=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Mp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Qa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new vs({vertexShader:zA,fragmentShader:VA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Le(new Wr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},wp=class extends Ji{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,d=null,h=null,f=null,g=null,y=typeof XRWebGLBinding<"u",p=new Mp,m={},x=t.getContextAttributes(),E=null,S=null,R=[],C=[],v=new ct,w=null,U=null,I=new fi;I.viewport=new an;let D=new fi;D.viewport=new an;let z=[I,D],G=new ku,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=R[ee];return me===void 0&&(me=new Qo,R[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=R[ee];return me===void 0&&(me=new Qo,R[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=R[ee];return me===void 0&&(me=new Qo,R[ee]=me),me.getHandSpace()};function $(ee){let me=C.indexOf(ee.inputSource);if(me===-1)return;let ve=R[me];ve!==void 0&&(ve.update(ee.inputSource,ee.frame,c||o),ve.dispatchEvent({type:ee.type,data:ee.inputSource}))}function H(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<R.length;ee++){let me=C[ee];me!==null&&(C[ee]=null,R[ee].disconnect(me))}N=null,W=null,p.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(E),f=null,h=null,d=null,s=null,S=null,de.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(v.width,v.height,!1),U!==null){let ee=U.camera;ee.fov=U.fov,ee.zoom=U.zoom,ee.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return h!==null?h:f},this.getBinding=function(){return d===null&&y&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(E=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",H),s.addEventListener("inputsourceschange",le),x.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(v),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Ce=null,Se=null;x.depth&&(Se=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=x.stencil?Ws:zs,Ce=x.stencil?Kr:es);let Ye={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};d=this.getBinding(),h=d.createProjectionLayer(Ye),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),S=new Ii(h.textureWidth,h.textureHeight,{format:Di,type:Kn,depthTexture:new Vs(h.textureWidth,h.textureHeight,Ce,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let ve={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new Ii(f.framebufferWidth,f.framebufferHeight,{format:Di,type:Kn,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),de.setContext(s),de.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function le(ee){for(let me=0;me<ee.removed.length;me++){let ve=ee.removed[me],Ce=C.indexOf(ve);Ce>=0&&(C[Ce]=null,R[Ce].disconnect(ve))}for(let me=0;me<ee.added.length;me++){let ve=ee.added[me],Ce=C.indexOf(ve);if(Ce===-1){for(let Ye=0;Ye<R.length;Ye++)if(Ye>=C.length){C.push(ve),Ce=Ye;break}else if(C[Ye]===null){C[Ye]=ve,Ce=Ye;break}if(Ce===-1)break}let Se=R[Ce];Se&&Se.connect(ve)}}function Y(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ve=ee.far;p.texture!==null&&(p.depthNear>0&&(me=p.depthNear),p.depthFar>0&&(ve=p.depthFar)),G.near=D.near=I.near=me,G.far=D.far=I.far=ve,(N!==G.near||W!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),N=G.near,W=G.far),G.layers.mask=ee.layers.mask|6,I.layers.mask=G.layers.mask&-5,D.layers.mask=G.layers.mask&-3;let Ce=ee.parent,Se=G.cameras;Y(G,Ce);for(let Ye=0;Ye<Se.length;Ye++)Y(Se[Ye],Ce);G.projectionMatrix.copy(I.projectionMatrix),G.projectionMatrixInverse.copy(I.projectionMatrixInverse),U===null&&ee.isPerspectiveCamera&&(U={camera:ee,fov:ee.fov,zoom:ee.zoom}),j(ee,G,Ce)};function j(ee,me,ve){ve===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ve.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=_u*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(h===null&&f===null))return l},this.setFoveation=function(ee){l=ee,h!==null&&(h.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(G)},this.getCameraTexture=function(ee){return m[ee]};let ie=null;function he(ee,me){if(u=me.getViewerPose(c||o),g=me,u!==null){let ve=u.views;f!==null&&(e.setRenderTargetFramebuffer(S,f.framebuffer),e.setRenderTarget(S));let Ce=!1;ve.length!==G.cameras.length&&(G.cameras.length=0,Ce=!0);for(let Xe=0;Xe<ve.length;Xe++){let pt=ve[Xe],ht=null;if(f!==null)ht=f.getViewport(pt);else{let sn=d.getViewSubImage(h,pt);ht=sn.viewport,Xe===0&&(e.setRenderTargetTextures(S,sn.colorTexture,sn.depthStencilTexture),e.setRenderTarget(S))}let rt=z[Xe];rt===void 0&&(rt=new fi,rt.layers.enable(Xe),rt.viewport=new an,z[Xe]=rt),rt.matrix.fromArray(pt.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(pt.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(ht.x,ht.y,ht.width,ht.height),Xe===0&&(G.matrix.copy(rt.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Ce===!0&&G.cameras.push(rt)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){d=i.getBinding();let Xe=d.getDepthInformation(ve[0]);Xe&&Xe.isValid&&Xe.texture&&p.init(Xe,s.renderState)}if(Se&&Se.includes("camera-access")&&y){e.state.unbindTexture(),d=i.getBinding();for(let Xe=0;Xe<ve.length;Xe++){let pt=ve[Xe].camera;if(pt){let ht=m[pt];ht||(ht=new Qa,m[pt]=ht);let rt=d.getCameraImage(pt);ht.sourceTexture=rt}}}}for(let ve=0;ve<R.length;ve++){let Ce=C[ve],Se=R[ve];Ce!==null&&Se!==void 0&&Se.update(Ce,me,c||o)}ie&&ie(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),g=null}let de=new Lv;de.setAnimationLoop(he),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},GA=new Mt,Gv=new it;Gv.set(-1,0,0,0,1,0,0,0,1);function HA(n,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,hp(n)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,x,E,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),d(p,m)):m.isMeshPhongMaterial?(r(p,m),u(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),h(p,m),m.isMeshPhysicalMaterial&&f(p,m,S)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),y(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,x,E):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===mi&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===mi&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let x=e.get(m),E=x.envMap,S=x.envMapRotation;E&&(p.envMap.value=E,p.envMapRotation.value.setFromMatrix4(GA.makeRotationFromEuler(S)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Gv),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,x,E){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*x,p.scale.value=E*.5,m.map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function u(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function d(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function h(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,x){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===mi&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=x.texture,p.transmissionSamplerSize.value.set(x.width,x.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function y(p,m){let x=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(x.matrixWorld),p.nearDistance.value=x.shadow.camera.near,p.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function WA(n,e,t,i){let s={},r={};function o(x,E){let S=E.program;i.uniformBlockBinding(x,S,s[x.id])}function a(x,E){let S=s[x.id];S===void 0&&(g(x),S=l(x),s[x.id]=S,x.addEventListener("dispose",p));let R=E.program;i.updateUBOMapping(x,R);let C=e.render.frame;r[x.id]!==C&&(c(x),r[x.id]=C)}function l(x){let E=n.createBuffer(),S=x.__size,R=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,E),n.bufferData(n.UNIFORM_BUFFER,S,R),n.bindBuffer(n.UNIFORM_BUFFER,null),E}function c(x){let E=s[x.id],S=x.uniforms,R=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let C=0,v=S.length;C<v;C++){let w=S[C];if(Array.isArray(w))for(let U=0,I=w.length;U<I;U++)u(w[U],C,U,R);else u(w,C,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,E,S,R){if(h(x,E,S,R)===!0){let C=x.__offset,v=x.value;if(Array.isArray(v)){let w=0;for(let U=0;U<v.length;U++){let I=v[U],D=y(I,!0);d(I,x.__data,w),w+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else d(v,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,C,x.__data)}}function d(x,E,S){typeof x=="number"||typeof x=="boolean"?E[S]=x:x.isMatrix3?(E[S]=x.elements[0],E[S+1]=x.elements[1],E[S+2]=x.elements[2],E[S+3]=0,E[S+4]=x.elements[3],E[S+5]=x.elements[4],E[S+6]=x.elements[5],E[S+7]=0,E[S+8]=x.elements[6],E[S+9]=x.elements[7],E[S+10]=x.elements[8],E[S+11]=0):ArrayBuffer.isView(x)?E.set(x.subarray(0,E.length-S),S):x.toArray(E,S)}function h(x,E,S,R){let C=x.value,v=E+"_"+S;if(Array.isArray(C)){R[v]===void 0&&(R[v]=[]);let w=R[v],U=!1;for(let I=0;I<C.length;I++)f(C[I],w,I)===!0&&(U=!0);return U}return f(C,R,v)}function f(x,E,S){if(E[S]===void 0)return typeof x=="number"||typeof x=="boolean"?E[S]=x:ArrayBuffer.isView(x)?E[S]=x.slice():E[S]=x.clone(),!0;{let R=E[S];if(typeof x=="number"||typeof x=="boolean"){if(R!==x)return E[S]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(R.equals(x)===!1)return R.copy(x),!0}}return!1}function g(x){let E=x.uniforms,S=0,R=16;for(let v=0,w=E.length;v<w;v++){let U=Array.isArray(E[v])?E[v]:[E[v]];for(let I=0,D=U.length;I<D;I++){let z=U[I],G=Array.isArray(z.value)?z.value:[z.value],N=Array.isArray(E[v])||Array.isArray(z.value),W=S;for(let H=0,le=G.length;H<le;H++){let Y=G[H],j=y(Y,N),ie=S%R,he=ie%j.boundary,de=ie+he;S+=he,de!==0&&R-de<j.storage&&(S+=R-de),H===0&&(W=S),S+=j.storage}let $=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new $((S-W)/Float32Array.BYTES_PER_ELEMENT),z.__offset=W}}let C=S%R;return C>0&&(S+=R-C),x.__size=S,x.__cache={},this}function y(x,E){let S={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(S.boundary=4,S.storage=4):x.isVector2?(S.boundary=8,S.storage=8):x.isVector3||x.isColor?(S.boundary=16,S.storage=12):x.isVector4?(S.boundary=16,S.storage=16):x.isMatrix3?(S.boundary=16,S.storage=48):x.isMatrix4?(S.boundary=16,S.storage=64):x.isTexture?Je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(S.boundary=16,S.storage=x.byteLength):Je("WebGLRenderer: Unsupported uniform value type.",x),E===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function p(x){let E=x.target;E.removeEventListener("dispose",p),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function m(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:m}}var XA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),bs=null;function qA(){return bs===null&&(bs=new Gr(XA,16,16,br,ns),bs.name="DFG_LUT",bs.minFilter=pi,bs.magFilter=pi,bs.wrapS=ms,bs.wrapT=ms,bs.generateMipmaps=!1,bs.needsUpdate=!0),bs}var Ch=class{constructor(e={}){let{canvas:t=nv(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:h=!1,outputBufferType:f=Kn}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let y=f,p=new Set([Yu,qu,ra]),m=new Set([Kn,es,yr,Kr,Wu,Xu]),x=new Uint32Array(4),E=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,C=null,v=[],w=[],U=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ys,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,D=!1,z=null,G=null,N=null,W=null;this._outputColorSpace=Pi;let $=0,H=0,le=null,Y=-1,j=null,ie=new an,he=new an,de=null,ee=new st(0),me=0,ve=t.width,Ce=t.height,Se=1,Ye=null,at=null,Xe=new an(0,0,ve,Ce),pt=new an(0,0,ve,Ce),ht=!1,rt=new fr,sn=new bu,Yt=!1,Mn=!1,zt=new Mt,zn=new O,Et=new an,Dn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},dn=!1;function wn(){return le===null?Se:1}let B=i;function Pe(A,V){return t.getContext(A,V)}let Ke,lt,Me,Gt,We,Ze,P,M,q,ue,oe,_e,xe,te,se,pe,k,re,ne,we,ge,be,qe;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",et,!1),t.addEventListener("webglcontextcreationerror",Re,!1),B===null){let V="webgl2";if(B=Pe(V,A),B===null)throw Pe(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}je()}catch(A){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),tt("WebGLRenderer: "+A.message),A}function je(){Ke=new iT(B),Ke.init(),ge=new BA(B,Ke),lt=new qE(B,Ke,e,ge),Me=new OA(B,Ke),lt.reversedDepthBuffer&&h&&Me.buffers.depth.setReversed(!0),G=B.createFramebuffer(),N=B.createFramebuffer(),W=B.createFramebuffer(),Gt=new oT(B),We=new MA,Ze=new kA(B,Ke,Me,We,lt,ge,Gt),P=new nT(I),M=new lw(B),be=new WE(B,M),q=new sT(B,M,Gt,be),ue=new lT(B,q,M,be,Gt),re=new aT(B,lt,Ze),se=new YE(We),oe=new SA(I,P,Ke,lt,be,se),_e=new HA(I,We),xe=new EA,te=new IA(Ke),k=new HE(I,P,Me,ue,g,l),pe=new UA(I,ue,lt),qe=new WA(B,Gt,lt,Me),ne=new XE(B,Ke,Gt),we=new rT(B,Ke,Gt),Gt.programs=oe.programs,I.capabilities=lt,I.extensions=Ke,I.properties=We,I.renderLists=xe,I.shadowMap=pe,I.state=Me,I.info=Gt}y!==Kn&&(U=new uT(y,t.width,t.height,a,s,r));let ce=new wp(I,B);this.xr=ce,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let A=Ke.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Ke.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=function(A){A!==void 0&&(Se=A,this.setSize(ve,Ce,!1))},this.getSize=function(A){return A.set(ve,Ce)},this.setSize=function(A,V,Q=!0){if(ce.isPresenting){Je("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=A,Ce=V,t.width=Math.floor(A*Se),t.height=Math.floor(V*Se),Q===!0&&(t.style.width=A+"px",t.style.height=V+"px"),U!==null&&U.setSize(t.width,t.height),this.setViewport(0,0,A,V)},this.getDrawingBufferSize=function(A){return A.set(ve*Se,Ce*Se).floor()},this.setDrawingBufferSize=function(A,V,Q){ve=A,Ce=V,Se=Q,t.width=Math.floor(A*Q),t.height=Math.floor(V*Q),this.setViewport(0,0,A,V)},this.setEffects=function(A){if(y===Kn){tt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let V=0;V<A.length;V++)if(A[V].isOutputPass===!0){Je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(ie)},this.getViewport=function(A){return A.copy(Xe)},this.setViewport=function(A,V,Q,Z){A.isVector4?Xe.set(A.x,A.y,A.z,A.w):Xe.set(A,V,Q,Z),Me.viewport(ie.copy(Xe).multiplyScalar(wn()).round())},this.getScissor=function(A){return A.copy(pt)},this.setScissor=function(A,V,Q,Z){A.isVector4?pt.set(A.x,A.y,A.z,A.w):pt.set(A,V,Q,Z),Me.scissor(he.copy(pt).multiplyScalar(wn()).round())},this.getScissorTest=function(){return ht},this.setScissorTest=function(A){Me.setScissorTest(ht=A)},this.setOpaqueSort=function(A){Ye=A},this.setTransparentSort=function(A){at=A},this.getClearColor=function(A){return A.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(A=!0,V=!0,Q=!0){let Z=0;if(A){let K=!1;if(le!==null){let Ee=le.texture.format;K=p.has(Ee)}if(K){let Ee=le.texture.type,Ie=m.has(Ee),Te=k.getClearColor(),De=k.getClearAlpha(),Ge=Te.r,nt=Te.g,gt=Te.b;Ie?(x[0]=Ge,x[1]=nt,x[2]=gt,x[3]=De,B.clearBufferuiv(B.COLOR,0,x)):(E[0]=Ge,E[1]=nt,E[2]=gt,E[3]=De,B.clearBufferiv(B.COLOR,0,E))}else Z|=B.COLOR_BUFFER_BIT}V&&(Z|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Z|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&B.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),z=A},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),k.dispose(),xe.dispose(),te.dispose(),Ze.dispose(),We.dispose(),P.dispose(),ue.dispose(),q.dispose(),be.dispose(),qe.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Cl),ce.removeEventListener("sessionend",is),ws.stop()};function Be(A){A.preventDefault(),cp("WebGLRenderer: Context Lost."),D=!0}function et(){cp("WebGLRenderer: Context Restored."),D=!1;let A=Gt.autoReset,V=pe.enabled,Q=pe.autoUpdate,Z=pe.needsUpdate,K=pe.type;je(),Gt.autoReset=A,pe.enabled=V,pe.autoUpdate=Q,pe.needsUpdate=Z,pe.type=K}function Re(A){tt("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ut(A){let V=A.target;V.removeEventListener("dispose",ut),Kt(V)}function Kt(A){ri(A),We.remove(A)}function ri(A){let V=We.get(A).programs;V!==void 0&&(V.forEach(function(Q){oe.releaseProgram(Q)}),A.isShaderMaterial&&oe.releaseShaderCache(A))}this.renderBufferDirect=function(A,V,Q,Z,K,Ee){V===null&&(V=Dn);let Ie=K.isMesh&&K.matrixWorld.determinantAffine()<0,Te=fa(A,V,Q,Z,K);Me.setMaterial(Z,Ie);let De=Q.index,Ge=1;if(Z.wireframe===!0){if(De=q.getWireframeAttribute(Q),De===void 0)return;Ge=2}let nt=Q.drawRange,gt=Q.attributes.position,ze=nt.start*Ge,_t=(nt.start+nt.count)*Ge;Ee!==null&&(ze=Math.max(ze,Ee.start*Ge),_t=Math.min(_t,(Ee.start+Ee.count)*Ge)),De!==null?(ze=Math.max(ze,0),_t=Math.min(_t,De.count)):gt!=null&&(ze=Math.max(ze,0),_t=Math.min(_t,gt.count));let un=_t-ze;if(un<0||un===1/0)return;be.setup(K,Z,Te,Q,De);let Ft,Ut=ne;if(De!==null&&(Ft=M.get(De),Ut=we,Ut.setIndex(Ft)),K.isMesh)Z.wireframe===!0?(Me.setLineWidth(Z.wireframeLinewidth*wn()),Ut.setMode(B.LINES)):Ut.setMode(B.TRIANGLES);else if(K.isLine){let Nn=Z.linewidth;Nn===void 0&&(Nn=1),Me.setLineWidth(Nn*wn()),K.isLineSegments?Ut.setMode(B.LINES):K.isLineLoop?Ut.setMode(B.LINE_LOOP):Ut.setMode(B.LINE_STRIP)}else K.isPoints?Ut.setMode(B.POINTS):K.isSprite&&Ut.setMode(B.TRIANGLES);if(K.isBatchedMesh)if(Ke.get("WEBGL_multi_draw"))Ut.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let Nn=K._multiDrawStarts,Oe=K._multiDrawCounts,En=K._multiDrawCount,yt=De?M.get(De).bytesPerElement:1,Ts=We.get(Z).currentProgram.getUniforms();for(let Tn=0;Tn<En;Tn++)Ts.setValue(B,"_gl_DrawID",Tn),Ut.render(Nn[Tn]/yt,Oe[Tn])}else if(K.isInstancedMesh)Ut.renderInstances(ze,un,K.count);else if(Q.isInstancedBufferGeometry){let Nn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Oe=Math.min(Q.instanceCount,Nn);Ut.renderInstances(ze,un,Oe)}else Ut.render(ze,un)};function ua(A,V,Q,Z){z!==null&&A.isNodeMaterial&&z.setObject(Z,A),Yt===!0&&se.setState(A,Q,!1),A.transparent===!0&&A.side===ii&&A.forceSinglePass===!1?(A.side=mi,A.needsUpdate=!0,ss(A,V,Z),A.side=xs,A.needsUpdate=!0,ss(A,V,Z),A.side=ii):ss(A,V,Z)}this.compile=function(A,V,Q=null){Q===null&&(Q=A),z!==null&&z.renderStart(A,V,Q),C=te.get(Q),C.init(V),w.push(C),Q.traverseVisible(function(K){K.isLight&&K.layers.test(V.layers)&&(C.pushLight(K),K.castShadow&&C.pushShadow(K))}),A!==Q&&A.traverseVisible(function(K){K.isLight&&K.layers.test(V.layers)&&(C.pushLight(K),K.castShadow&&C.pushShadow(K))}),C.setupLights(),z!==null&&z.updateLights(C.state.lightsArray),Mn=this.localClippingEnabled,Yt=se.init(this.clippingPlanes,Mn),Yt===!0&&se.setGlobalState(this.clippingPlanes,V),z!==null&&pe.render(C.state.shadowsArray,Q,V);let Z=new Set;return A.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ee=K.material;if(Ee)if(Array.isArray(Ee))for(let Ie=0;Ie<Ee.length;Ie++){let Te=Ee[Ie];ua(Te,Q,V,K),Z.add(Te)}else ua(Ee,Q,V,K),Z.add(Ee)}),C=w.pop(),z!==null&&z.renderEnd(),Z},this.compileAsync=function(A,V,Q=null){let Z=this.compile(A,V,Q);return new Promise(K=>{function Ee(){if(Z.forEach(function(Ie){let De=We.get(Ie).currentProgram;(De===void 0||De.isReady())&&Z.delete(Ie)}),Z.size===0){K(A);return}setTimeout(Ee,10)}Ke.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let to=null;function Zh(A){to&&to(A)}function Cl(){ws.stop()}function is(){ws.start()}let ws=new Lv;ws.setAnimationLoop(Zh),typeof self<"u"&&ws.setContext(self),this.setAnimationLoop=function(A){to=A,ce.setAnimationLoop(A),A===null?ws.stop():ws.start()},ce.addEventListener("sessionstart",Cl),ce.addEventListener("sessionend",is),this.render=function(A,V){if(V!==void 0&&V.isCamera!==!0){tt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;z!==null&&z.renderStart(A,V);let Q=ce.enabled===!0&&ce.isPresenting===!0,Z=U!==null&&(le===null||Q)&&U.begin(I,le);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(V),V=ce.getCamera()),A.isScene===!0&&A.onBeforeRender(I,A,V,le),C=te.get(A,w.length),C.init(V),C.state.textureUnits=Ze.getTextureUnits(),w.push(C),zt.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?sn.setFromArrayCamera(V):rt.setFromProjectionMatrix(zt,zi,V.reversedDepth),Mn=this.localClippingEnabled,Yt=se.init(this.clippingPlanes,Mn),R=xe.get(A,v.length),R.init(),v.push(R),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Ie=I.xr.getDepthSensingMesh();Ie!==null&&Es(Ie,V,-1/0,I.sortObjects)}Es(A,V,0,I.sortObjects),R.finish(),z!==null&&z.updateLights(C.state.lightsArray),I.sortObjects===!0&&R.sort(Ye,at),dn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,dn&&k.addToRenderList(R,A),this.info.autoReset===!0&&this.info.reset(),Yt===!0&&se.beginShadows();let K=C.state.shadowsArray;if(pe.render(K,A,V),Yt===!0&&se.endShadows(),(Z&&U.hasRenderPass())===!1){let Ie=R.opaque,Te=R.transmissive;if(C.setupLights(),V.isArrayCamera){let De=V.cameras;if(Te.length>0)for(let Ge=0,nt=De.length;Ge<nt;Ge++){let gt=De[Ge];Vi(Ie,Te,A,gt)}dn&&k.render(A);for(let Ge=0,nt=De.length;Ge<nt;Ge++){let gt=De[Ge];ha(R,A,gt,gt.viewport)}}else Te.length>0&&Vi(Ie,Te,A,V),dn&&k.render(A),ha(R,A,V)}le!==null&&H===0&&(Ze.updateMultisampleRenderTarget(le),Ze.updateRenderTargetMipmap(le)),Z&&U.end(I),A.isScene===!0&&A.onAfterRender(I,A,V),be.resetDefaultState(),Y=-1,j=null,w.pop(),w.length>0?(C=w[w.length-1],Ze.setTextureUnits(C.state.textureUnits),Yt===!0&&se.setGlobalState(I.clippingPlanes,C.state.camera)):C=null,v.pop(),v.length>0?R=v[v.length-1]:R=null,z!==null&&z.renderEnd()};function Es(A,V,Q,Z){if(A.visible===!1)return;if(A.layers.test(V.layers)){if(A.isGroup)Q=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(V);else if(A.isLight)C.pushLight(A),A.castShadow&&C.pushShadow(A);else if(A.isSprite){let Ie=V.isArrayCamera?sn:rt;if(!A.frustumCulled||A.intersectsFrustum(Ie)){Z&&Et.setFromMatrixPosition(A.matrixWorld).applyMatrix4(zt);let Te=ue.update(A),De=A.material;De.visible&&R.push(A,Te,De,Q,Et.z,null,V)}}else if(A.isMesh||A.isLine||A.isPoints){let Ie=V.isArrayCamera?sn:rt;if(!A.frustumCulled||A.intersectsFrustum(Ie)){let Te=ue.update(A),De=A.material;if(Z&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),Et.copy(A.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),Et.copy(Te.boundingSphere.center)),Et.applyMatrix4(A.matrixWorld).applyMatrix4(zt)),Array.isArray(De)){let Ge=Te.groups;for(let nt=0,gt=Ge.length;nt<gt;nt++){let ze=Ge[nt],_t=De[ze.materialIndex];_t&&_t.visible&&R.push(A,Te,_t,Q,Et.z,ze,V)}}else De.visible&&R.push(A,Te,De,Q,Et.z,null,V)}}}let Ee=A.children;for(let Ie=0,Te=Ee.length;Ie<Te;Ie++)Es(Ee[Ie],V,Q,Z)}function ha(A,V,Q,Z){let{opaque:K,transmissive:Ee,transparent:Ie}=A;C.setupLightsView(Q),Yt===!0&&se.setGlobalState(I.clippingPlanes,Q),Z&&Me.viewport(ie.copy(Z)),K.length>0&&fn(K,V,Q),Ee.length>0&&fn(Ee,V,Q),Ie.length>0&&fn(Ie,V,Q),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),Me.setPolygonOffset(!1)}function Vi(A,V,Q,Z){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[Z.id]===void 0){let ze=Ke.has("EXT_color_buffer_half_float")||Ke.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[Z.id]=new Ii(1,1,{generateMipmaps:!0,type:ze?ns:Kn,minFilter:Hs,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let Ee=C.state.transmissionRenderTarget[Z.id],Ie=Z.viewport||ie;Ee.setSize(Ie.z*I.transmissionResolutionScale,Ie.w*I.transmissionResolutionScale);let Te=I.getRenderTarget(),De=I.getActiveCubeFace(),Ge=I.getActiveMipmapLevel();I.setRenderTarget(Ee),I.getClearColor(ee),me=I.getClearAlpha(),me<1&&I.setClearColor(16777215,.5),I.clear(),dn&&k.render(Q);let nt=I.toneMapping;I.toneMapping=ys;let gt=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),C.setupLightsView(Z),Yt===!0&&se.setGlobalState(I.clippingPlanes,Z),fn(A,Q,Z),Ze.updateMultisampleRenderTarget(Ee),Ze.updateRenderTargetMipmap(Ee),Ke.has("WEBGL_multisampled_render_to_texture")===!1){let ze=!1;for(let _t=0,un=V.length;_t<un;_t++){let Ft=V[_t],{object:Ut,geometry:Nn,material:Oe,group:En}=Ft;if(Oe.side===ii&&Ut.layers.test(Z.layers)){let yt=Oe.side;Oe.side=mi,Oe.needsUpdate=!0,yn(Ut,Q,Z,Nn,Oe,En),Oe.side=yt,Oe.needsUpdate=!0,ze=!0}}ze===!0&&(Ze.updateMultisampleRenderTarget(Ee),Ze.updateRenderTargetMipmap(Ee))}I.setRenderTarget(Te,De,Ge),I.setClearColor(ee,me),gt!==void 0&&(Z.viewport=gt),I.toneMapping=nt}function fn(A,V,Q){let Z=V.isScene===!0?V.overrideMaterial:null;for(let K=0,Ee=A.length;K<Ee;K++){let Ie=A[K],{object:Te,geometry:De,group:Ge}=Ie,nt=Ie.material;nt.allowOverride===!0&&Z!==null&&(nt=Z),Te.layers.test(Q.layers)&&yn(Te,V,Q,De,nt,Ge)}}function yn(A,V,Q,Z,K,Ee){z!==null&&K.isNodeMaterial&&z.setObject(A,K),A.onBeforeRender(I,V,Q,Z,K,Ee),A.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),K.onBeforeRender(I,V,Q,Z,A,Ee),K.transparent===!0&&K.side===ii&&K.forceSinglePass===!1?(K.side=mi,K.needsUpdate=!0,I.renderBufferDirect(Q,V,Z,K,A,Ee),K.side=xs,K.needsUpdate=!0,I.renderBufferDirect(Q,V,Z,K,A,Ee),K.side=ii):I.renderBufferDirect(Q,V,Z,K,A,Ee),A.onAfterRender(I,V,Q,Z,K,Ee)}function bn(A){let V=0;for(let Q of A)Q.texture!==null&&V++;return V}function ss(A,V,Q){V.isScene!==!0&&(V=Dn);let Z=We.get(A),K=C.state.lights,Ee=C.state.shadowsArray,Ie=K.state.version,Te=oe.getParameters(A,K.state,Ee,V,Q,C.state.lightProbeGridArray),De=oe.getProgramCacheKey(Te),Ge=Z.programs;Z.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?V.environment:null,Z.fog=V.fog;let nt=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;Z.envMap=P.get(A.envMap||Z.environment,nt),Z.envMapRotation=Z.environment!==null&&A.envMap===null?V.environmentRotation:A.envMapRotation,Ge===void 0&&(A.addEventListener("dispose",ut),Ge=new Map,Z.programs=Ge,Z.programVariants=new Map);let gt=Ge.get(De);if(gt!==void 0){if(Z.currentProgram===gt&&Z.lightsStateVersion===Ie)return da(A,Te),gt}else Te.uniforms=oe.getUniforms(A),z!==null&&A.isNodeMaterial&&z.build(A,Q,Te),A.onBeforeCompile(Te,I),gt=oe.acquireProgram(Te,De),Ge.set(De,gt),Z.uniforms=Te.uniforms;let ze=Z.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(ze.clippingPlanes=se.uniform),da(A,Te),Z.needsLights=Ys(A),Z.lightsStateVersion=Ie,Z.needsLights&&(ze.ambientLightColor.value=K.state.ambient,ze.lightProbe.value=K.state.probe,ze.sunLights.value=K.state.sun,ze.sunLightShadows.value=K.state.sunShadow,ze.directionalLights.value=K.state.directional,ze.directionalLightShadows.value=K.state.directionalShadow,ze.spotLights.value=K.state.spot,ze.spotLightShadows.value=K.state.spotShadow,ze.rectAreaLights.value=K.state.rectArea,ze.ltc_1.value=K.state.rectAreaLTC1,ze.ltc_2.value=K.state.rectAreaLTC2,ze.pointLights.value=K.state.point,ze.pointLightShadows.value=K.state.pointShadow,ze.hemisphereLights.value=K.state.hemi,ze.sunShadowMatrix.value=K.state.sunShadowMatrix,ze.sunShadowCascade.value=K.state.sunShadowCascade,ze.directionalShadowMatrix.value=K.state.directionalShadowMatrix,ze.spotLightMatrix.value=K.state.spotLightMatrix,ze.spotLightMap.value=K.state.spotLightMap,ze.pointShadowMatrix.value=K.state.pointShadowMatrix),Z.numLightProbeGrids=bn(C.state.lightProbeGridArray),Z.currentProgram=gt,Z.uniformsList=null,gt}function yi(A,V,Q,Z,K){let Ee=We.get(A),Ie=Ee.currentProgram.id+","+Z+","+K,Te=Ee.programVariants.get(Ie);return Te===void 0?(Te=ss(A,V,Q),Ee.programVariants.set(Ie,Te)):(Ee.currentProgram=Te,Ee.uniformsList=null,Ee.outputColorSpace=Z,Ee.toneMapping=K),Te}function qs(A){if(A.uniformsList===null){let V=A.currentProgram.getUniforms();A.uniformsList=oa.seqWithValue(V.seq,A.uniforms)}return A.uniformsList}function da(A,V){let Q=We.get(A);Q.outputColorSpace=V.outputColorSpace,Q.batching=V.batching,Q.batchingColor=V.batchingColor,Q.instancing=V.instancing,Q.instancingColor=V.instancingColor,Q.instancingMorph=V.instancingMorph,Q.skinning=V.skinning,Q.morphTargets=V.morphTargets,Q.morphNormals=V.morphNormals,Q.morphColors=V.morphColors,Q.morphTargetsCount=V.morphTargetsCount,Q.numClippingPlanes=V.numClippingPlanes,Q.numIntersection=V.numClipIntersection,Q.vertexAlphas=V.vertexAlphas,Q.vertexTangents=V.vertexTangents,Q.toneMapping=V.toneMapping}function fa(A,V,Q,Z,K){V.isScene!==!0&&(V=Dn),Ze.resetTextureUnits();let Ee=V.fog,Ie=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?V.environment:null,Te=le===null?I.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:St.workingColorSpace,De=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,Ge=P.get(Z.envMap||Ie,De),nt=Z.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,gt=!!Q.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),ze=!!Q.morphAttributes.position,_t=!!Q.morphAttributes.normal,un=!!Q.morphAttributes.color,Ft=ys;Z.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Ft=I.toneMapping);let Ut=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,Nn=Ut!==void 0?Ut.length:0,Oe=We.get(Z),En=C.state.lights;if(Yt===!0&&(Mn===!0||A!==j)){let Ot=A===j&&Z.id===Y;se.setState(Z,A,Ot)}let yt=!1,Ts=!1;Z.version===Oe.__version?Oe.needsLights&&Oe.lightsStateVersion!==En.state.version||K.isBatchedMesh&&Oe.batching===!1||!K.isBatchedMesh&&Oe.batching===!0||K.isBatchedMesh&&Oe.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Oe.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Oe.instancing===!1||!K.isInstancedMesh&&Oe.instancing===!0||K.isSkinnedMesh&&Oe.skinning===!1||!K.isSkinnedMesh&&Oe.skinning===!0||K.isInstancedMesh&&Oe.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Oe.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Oe.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Oe.instancingMorph===!1&&K.morphTexture!==null||Oe.envMap!==Ge||Z.fog===!0&&Oe.fog!==Ee||Oe.numClippingPlanes!==void 0&&(Oe.numClippingPlanes!==se.numPlanes||Oe.numIntersection!==se.numIntersection)||Oe.vertexAlphas!==nt||Oe.vertexTangents!==gt||Oe.morphTargets!==ze||Oe.morphNormals!==_t||Oe.morphColors!==un||Oe.morphTargetsCount!==Nn||Oe.numLightProbeGrids!==bn(C.state.lightProbeGridArray)?yt=!0:(Oe.outputColorSpace!==Te||Oe.toneMapping!==Ft)&&(Ts=!0):(yt=!0,Oe.__version=Z.version);let Tn=Oe.currentProgram;(yt===!0||Ts===!0)&&(Tn=Ts===!0?yi(Z,V,K,Te,Ft):ss(Z,V,K),z&&Z.isNodeMaterial&&z.onUpdateProgram(Z,Tn,Oe));let so=!1,rs=!1,As=!1,dt=Tn.getUniforms(),pn=Oe.uniforms;if(Me.useProgram(Tn.program)&&(so=!0,rs=!0,As=!0),Z.id!==Y&&(Y=Z.id,rs=!0),so||j!==A){Me.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),dt.setValue(B,"projectionMatrix",A.projectionMatrix),dt.setValue(B,"viewMatrix",A.matrixWorldInverse);let An=dt.map.cameraPosition;An!==void 0&&An.setValue(B,zn.setFromMatrixPosition(A.matrixWorld)),lt.logarithmicDepthBuffer&&dt.setValue(B,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&dt.setValue(B,"isOrthographic",A.isOrthographicCamera===!0),j!==A&&(j=A,rs=!0,As=!0)}if(Oe.needsLights&&(En.state.sunShadowMap.length>0&&dt.setValue(B,"sunShadowMap",En.state.sunShadowMap,Ze),En.state.directionalShadowMap.length>0&&dt.setValue(B,"directionalShadowMap",En.state.directionalShadowMap,Ze),En.state.spotShadowMap.length>0&&dt.setValue(B,"spotShadowMap",En.state.spotShadowMap,Ze),En.state.pointShadowMap.length>0&&dt.setValue(B,"pointShadowMap",En.state.pointShadowMap,Ze)),K.isSkinnedMesh){dt.setOptional(B,K,"bindMatrix"),dt.setOptional(B,K,"bindMatrixInverse");let Ot=K.skeleton;Ot&&(Ot.boneTexture===null&&Ot.computeBoneTexture(),dt.setValue(B,"boneTexture",Ot.boneTexture,Ze))}K.isBatchedMesh&&(dt.setOptional(B,K,"batchingTexture"),dt.setValue(B,"batchingTexture",K._matricesTexture,Ze),dt.setOptional(B,K,"batchingIdTexture"),dt.setValue(B,"batchingIdTexture",K._indirectTexture,Ze),dt.setOptional(B,K,"batchingColorTexture"),K._colorsTexture!==null&&dt.setValue(B,"batchingColorTexture",K._colorsTexture,Ze));let oi=Q.morphAttributes;if((oi.position!==void 0||oi.normal!==void 0||oi.color!==void 0)&&re.update(K,Q,Tn),(rs||Oe.receiveShadow!==K.receiveShadow)&&(Oe.receiveShadow=K.receiveShadow,dt.setValue(B,"receiveShadow",K.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&V.environment!==null&&(pn.envMapIntensity.value=V.environmentIntensity),pn.dfgLUT!==void 0&&(pn.dfgLUT.value=qA()),rs){if(dt.setValue(B,"toneMappingExposure",I.toneMappingExposure),Oe.needsLights&&no(pn,As),Ee&&Z.fog===!0&&_e.refreshFogUniforms(pn,Ee),_e.refreshMaterialUniforms(pn,Z,Se,Ce,C.state.transmissionRenderTarget[A.id]),Oe.needsLights&&Oe.numLightProbeGrids>0){let Ot=S,An=0;for(let Jn of C.state.lightProbeGridArray)Jn.texture!==null&&(Ot.textures[An]=Jn.texture,Ot.min[An]=Jn.boundingBox.min,Ot.max[An]=Jn.boundingBox.max,Ot.resolution[An]=Jn.resolution,An++);for(let Jn in Ot)Ot[Jn].length=An;pn.probesSH.value=Ot.textures,pn.probesMin.value=Ot.min,pn.probesMax.value=Ot.max,pn.probesResolution.value=Ot.resolution}oa.upload(B,qs(Oe),pn,Ze)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(oa.upload(B,qs(Oe),pn,Ze),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&dt.setValue(B,"center",K.center),dt.setValue(B,"modelViewMatrix",K.modelViewMatrix),dt.setValue(B,"normalMatrix",K.normalMatrix),dt.setValue(B,"modelMatrix",K.matrixWorld),Z.uniformsGroups!==void 0){let Ot=Z.uniformsGroups;for(let An=0,Jn=Ot.length;An<Jn;An++){let Rl=Ot[An];qe.update(Rl,Tn),qe.bind(Rl,Tn)}}return Tn}function no(A,V){A.ambientLightColor.needsUpdate=V,A.lightProbe.needsUpdate=V,A.sunLights.needsUpdate=V,A.sunLightShadows.needsUpdate=V,A.directionalLights.needsUpdate=V,A.directionalLightShadows.needsUpdate=V,A.pointLights.needsUpdate=V,A.pointLightShadows.needsUpdate=V,A.spotLights.needsUpdate=V,A.spotLightShadows.needsUpdate=V,A.rectAreaLights.needsUpdate=V,A.hemisphereLights.needsUpdate=V}function Ys(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(A,V,Q){let Z=We.get(A);Z.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),We.get(A.texture).__webglTexture=V,We.get(A.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:Q,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,V){let Q=We.get(A);Q.__webglFramebuffer=V,Q.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(A,V=0,Q=0){le=A,$=V,H=Q;let Z=null,K=!1,Ee=!1;if(A){let Te=We.get(A);if(Te.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(B.FRAMEBUFFER,Te.__webglFramebuffer),ie.copy(A.viewport),he.copy(A.scissor),de=A.scissorTest,Me.viewport(ie),Me.scissor(he),Me.setScissorTest(de),Y=-1;return}else if(Te.__webglFramebuffer===void 0)Ze.setupRenderTarget(A);else if(Te.__hasExternalTextures)Ze.rebindTextures(A,We.get(A.texture).__webglTexture,We.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let nt=A.depthTexture;if(Te.__boundDepthTexture!==nt){if(nt!==null&&We.has(nt)&&(A.width!==nt.image.width||A.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(A)}}let De=A.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ee=!0);let Ge=We.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(Ge[V])?Z=Ge[V][Q]:Z=Ge[V],K=!0):A.samples>0&&Ze.useMultisampledRTT(A)===!1?Z=We.get(A).__webglMultisampledFramebuffer:Array.isArray(Ge)?Z=Ge[Q]:Z=Ge,ie.copy(A.viewport),he.copy(A.scissor),de=A.scissorTest}else ie.copy(Xe).multiplyScalar(Se).floor(),he.copy(pt).multiplyScalar(Se).floor(),de=ht;if(Q!==0&&(Z=G),Me.bindFramebuffer(B.FRAMEBUFFER,Z)&&Me.drawBuffers(A,Z),Me.viewport(ie),Me.scissor(he),Me.setScissorTest(de),K){let Te=We.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+V,Te.__webglTexture,Q)}else if(Ee){let Te=V;for(let De=0;De<A.textures.length;De++){let Ge=We.get(A.textures[De]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+De,Ge.__webglTexture,Q,Te)}}else if(A!==null&&Q!==0){let Te=We.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Te.__webglTexture,Q)}Y=-1};function io(A){let V=We.get(A);return(V.__readFormat!==A.format||V.__readType!==A.type)&&(V.__readFormat=A.format,V.__readType=A.type,V.__formatReadable=lt.textureFormatReadable(A.format),V.__typeReadable=lt.textureTypeReadable(A.type)),V}this.readRenderTargetPixels=function(A,V,Q,Z,K,Ee,Ie,Te=0){if(!(A&&A.isWebGLRenderTarget)){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=We.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ie!==void 0&&(De=De[Ie],Array.isArray(De)&&(De=De[0])),De){Me.bindFramebuffer(B.FRAMEBUFFER,De);try{let Ge=A.textures[Te],nt=Ge.format,gt=Ge.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Te);let ze=io(Ge);if(ze.__formatReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ze.__typeReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=A.width-Z&&Q>=0&&Q<=A.height-K&&B.readPixels(V,Q,Z,K,ge.convert(nt),ge.convert(gt),Ee)}finally{let Ge=le!==null?We.get(le).__webglFramebuffer:null;Me.bindFramebuffer(B.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(A,V,Q,Z,K,Ee,Ie,Te=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=We.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ie!==void 0&&(De=De[Ie],Array.isArray(De)&&(De=De[0])),De)if(V>=0&&V<=A.width-Z&&Q>=0&&Q<=A.height-K){Me.bindFramebuffer(B.FRAMEBUFFER,De);let Ge=A.textures[Te],nt=Ge.format,gt=Ge.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Te);let ze=io(Ge);if(ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _t=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,_t),B.bufferData(B.PIXEL_PACK_BUFFER,Ee.byteLength,B.STREAM_READ),B.readPixels(V,Q,Z,K,ge.convert(nt),ge.convert(gt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let un=le!==null?We.get(le).__webglFramebuffer:null;Me.bindFramebuffer(B.FRAMEBUFFER,un);let Ft=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await sv(B,Ft,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,_t),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Ee),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(_t),B.deleteSync(Ft),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,V=null,Q=0){let Z=Math.pow(2,-Q),K=Math.floor(A.image.width*Z),Ee=Math.floor(A.image.height*Z),Ie=V!==null?V.x:0,Te=V!==null?V.y:0;Ze.setTexture2D(A,0),B.copyTexSubImage2D(B.TEXTURE_2D,Q,0,0,Ie,Te,K,Ee),Me.unbindTexture()},this.copyTextureToTexture=function(A,V,Q=null,Z=null,K=0,Ee=0){let Ie,Te,De,Ge,nt,gt,ze,_t,un,Ft=A.isCompressedTexture?A.mipmaps[Ee]:A.image;if(Q!==null)Ie=Q.max.x-Q.min.x,Te=Q.max.y-Q.min.y,De=Q.isBox3?Q.max.z-Q.min.z:1,Ge=Q.min.x,nt=Q.min.y,gt=Q.isBox3?Q.min.z:0;else{let dt=Math.pow(2,-K);Ie=Math.floor(Ft.width*dt),Te=Math.floor(Ft.height*dt),A.isDataArrayTexture?De=Ft.depth:A.isData3DTexture?De=Math.floor(Ft.depth*dt):De=1,Ge=0,nt=0,gt=0}Z!==null?(ze=Z.x,_t=Z.y,un=Z.z):(ze=0,_t=0,un=0);let Ut=ge.convert(V.format),Nn=ge.convert(V.type),Oe;V.isData3DTexture?(Ze.setTexture3D(V,0),Oe=B.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Ze.setTexture2DArray(V,0),Oe=B.TEXTURE_2D_ARRAY):(Ze.setTexture2D(V,0),Oe=B.TEXTURE_2D),Me.activeTexture(B.TEXTURE0),Me.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,V.flipY),Me.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),Me.pixelStorei(B.UNPACK_ALIGNMENT,V.unpackAlignment);let En=Me.getParameter(B.UNPACK_ROW_LENGTH),yt=Me.getParameter(B.UNPACK_IMAGE_HEIGHT),Ts=Me.getParameter(B.UNPACK_SKIP_PIXELS),Tn=Me.getParameter(B.UNPACK_SKIP_ROWS),so=Me.getParameter(B.UNPACK_SKIP_IMAGES);Me.pixelStorei(B.UNPACK_ROW_LENGTH,Ft.width),Me.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Ft.height),Me.pixelStorei(B.UNPACK_SKIP_PIXELS,Ge),Me.pixelStorei(B.UNPACK_SKIP_ROWS,nt),Me.pixelStorei(B.UNPACK_SKIP_IMAGES,gt);let rs=A.isDataArrayTexture||A.isData3DTexture,As=V.isDataArrayTexture||V.isData3DTexture;if(A.isDepthTexture){let dt=We.get(A),pn=We.get(V),oi=We.get(dt.__renderTarget),Ot=We.get(pn.__renderTarget);Me.bindFramebuffer(B.READ_FRAMEBUFFER,oi.__webglFramebuffer),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,Ot.__webglFramebuffer);for(let An=0;An<De;An++)rs&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,We.get(A).__webglTexture,K,gt+An),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,We.get(V).__webglTexture,Ee,un+An)),B.blitFramebuffer(Ge,nt,Ge+Ie,nt+Te,ze,_t,ze+Ie,_t+Te,B.DEPTH_BUFFER_BIT,B.NEAREST);Me.bindFramebuffer(B.READ_FRAMEBUFFER,null),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(K!==0||A.isRenderTargetTexture||We.has(A)){let dt=We.get(A),pn=We.get(V);Me.bindFramebuffer(B.READ_FRAMEBUFFER,N),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,W);for(let oi=0;oi<De;oi++)rs?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,dt.__webglTexture,K,gt+oi):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,dt.__webglTexture,K),As?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,pn.__webglTexture,Ee,un+oi):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,pn.__webglTexture,Ee),K!==0?B.blitFramebuffer(Ge,nt,Ge+Ie,nt+Te,ze,_t,ze+Ie,_t+Te,B.COLOR_BUFFER_BIT,B.NEAREST):As?B.copyTexSubImage3D(Oe,Ee,ze,_t,un+oi,Ge,nt,Ie,Te):B.copyTexSubImage2D(Oe,Ee,ze,_t,Ge,nt,Ie,Te);Me.bindFramebuffer(B.READ_FRAMEBUFFER,null),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else As?A.isDataTexture||A.isData3DTexture?B.texSubImage3D(Oe,Ee,ze,_t,un,Ie,Te,De,Ut,Nn,Ft.data):V.isCompressedArrayTexture?B.compressedTexSubImage3D(Oe,Ee,ze,_t,un,Ie,Te,De,Ut,Ft.data):B.texSubImage3D(Oe,Ee,ze,_t,un,Ie,Te,De,Ut,Nn,Ft):A.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Ee,ze,_t,Ie,Te,Ut,Nn,Ft.data):A.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Ee,ze,_t,Ft.width,Ft.height,Ut,Ft.data):B.texSubImage2D(B.TEXTURE_2D,Ee,ze,_t,Ie,Te,Ut,Nn,Ft);Me.pixelStorei(B.UNPACK_ROW_LENGTH,En),Me.pixelStorei(B.UNPACK_IMAGE_HEIGHT,yt),Me.pixelStorei(B.UNPACK_SKIP_PIXELS,Ts),Me.pixelStorei(B.UNPACK_SKIP_ROWS,Tn),Me.pixelStorei(B.UNPACK_SKIP_IMAGES,so),Ee===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&B.generateMipmap(Oe),Me.unbindTexture()},this.initRenderTarget=function(A){We.get(A).__webglFramebuffer===void 0&&Ze.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Ze.setTextureCube(A,0):A.isData3DTexture?Ze.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Ze.setTexture2DArray(A,0):Ze.setTexture2D(A,0),Me.unbindTexture()},this.resetState=function(){$=0,H=0,le=null,Me.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return zi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};var YA={depth:0,error:1,reason:2,oak:3},$A=`
precision highp float;
precision highp int;
precision highp usampler2D;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform usampler2D depth;
uniform usampler2D truth;
uniform usampler2D measured;
uniform usampler2D reasons;
uniform sampler2D table;
uniform vec2 tangent;
uniform vec2 range;
uniform int mode;
uniform int stride;
uniform bool isRelative;
uniform vec3 color;
uniform float pointSize;
in float unused;
out vec3 shade;

vec3 lookUp(float from0to1) {
  return texture(table, vec2((clamp(from0to1, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

void main() {
  ivec2 size = textureSize(depth, 0);
  int columns = size.x / stride;
  ivec2 pixel = ivec2(gl_VertexID % columns, gl_VertexID / columns) * stride;
  uint value = texelFetch(depth, pixel, 0).r;
  float z = float(value) * 0.001;
  vec2 place = (vec2(pixel) + 0.5) / vec2(size) * 2.0 - 1.0;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place * tangent * z, z, 1.0);
  gl_PointSize = pointSize;
  shade = color;
  bool isDropped = value == 0u;
  if (mode == 0) {
    shade = lookUp((z - range.x) / max(range.y - range.x, 1e-6));
  } else if (mode == 1) {
    uint exact = texelFetch(truth, pixel, 0).r;
    uint found = texelFetch(measured, pixel, 0).r;
    float error = (float(found) - float(exact)) * 0.001;
    if (isRelative) error *= 100.0 / max(float(exact) * 0.001, 1e-3);
    shade = found == 0u ? vec3(0.42) : lookUp(0.5 + 0.5 * error / max(range.y, 1e-9));
    isDropped = isDropped || exact == 0u;
  } else if (mode == 2) {
    shade = texelFetch(table, ivec2(int(texelFetch(reasons, pixel, 0).r), 0), 0).rgb;
  }
  if (isDropped) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`,ZA=`
precision highp float;
in vec3 shade;
out vec4 result;
void main() {
  result = vec4(shade, 1.0);
}`;function KA(n){let e=n.format==="u16mm",t=new Gr(n.data,n.width,n.height,ra,e?yr:Kn);return t.internalFormat=e?"R16UI":"R8UI",t.minFilter=t.magFilter=Ln,t.unpackAlignment=1,t.needsUpdate=!0,t}function Hv(n){let{width:e,height:t}=n.depth,i=Math.max(1,Math.ceil(Math.sqrt(e*t/n.maxPoints))),s=Math.floor(e/i)*Math.floor(t/i),r=new Nt;r.setAttribute("unused",new Zn(new Uint8Array(s),1)),r.setDrawRange(0,s);let o=new Map,a=h=>{let f=h??n.depth,g=o.get(f)??KA(f);return o.set(f,g),g},l=new Gr(n.table,n.table.length/4,1,Di,Kn);l.needsUpdate=!0;let c=h=>Math.tan(h*Math.PI/360),u=new ea({glslVersion:_l,vertexShader:$A,fragmentShader:ZA,uniforms:{depth:{value:a(n.depth)},truth:{value:a(n.truth)},measured:{value:a(n.measured)},reasons:{value:a(n.reasons)},table:{value:l},tangent:{value:new ct(c(n.hfovDeg),c(n.vfovDeg))},range:{value:new ct(...n.range)},mode:{value:YA[n.mode]},stride:{value:i},isRelative:{value:n.isRelative},color:{value:new O(...n.color)},pointSize:{value:n.pointSize}}});u.addEventListener("dispose",()=>{for(let h of o.values())h.dispose();l.dispose()});let d=new Hr(r,u);return d.frustumCulled=!1,d.matrixAutoUpdate=!1,d}function Wv(n,e,t){n.matrix.multiplyMatrices(e,t),n.matrixWorldNeedsUpdate=!0}var JA=Float32Array.from({length:256},(n,e)=>{let t=e/255;return t<=.04045?t/12.92:((t+.055)/1.055)**2.4});function Xv(n,e){let t=new Uint8Array(n.header.vertices*4);n.indices.forEach((s,r)=>t.set(e(n.objects[Math.floor(r/3)]??0),s*4));let i=Ml({...n,colors:t},!1);return i.material.polygonOffset=!0,i.material.polygonOffsetFactor=-2,i.material.polygonOffsetUnits=-4,i}function Ml(n,e){let t=new Nt,{vertices:i}=n.header,s=new Float32Array(i*3);for(let o=0;o<i;o++)for(let a=0;a<3;a++)s[o*3+a]=JA[n.colors[o*4+a]??0]??0;t.setAttribute("position",new Zn(n.positions,3)),t.setAttribute("color",new Zn(s,3)),t.setIndex(new Zn(n.indices,1)),t.computeBoundingSphere();let r=e?ii:xs;return new Le(t,new qr({vertexColors:!0,flatShading:!0,side:r}))}var QA=.25,jA=150,Ih={minimum:"#e5484d",ideal:"#2fa36b",maximum:"#d9822b"};function Yv(n){let e=new ti;if(e.add(eC(n)),n.showCameras)for(let t of n.model.cameras){let{hfovDeg:i,vfovDeg:s,bodyFromCamera:r}=t,o=Kv(i,s,QA,on(n.color),n.isSelected?.9:.45);e.add(qv(o,r))}return n.showRanges&&n.sensor&&e.add(qv(nC(n.sensor,n),n.sensor.bodyFromCamera)),e}function Qr(n){n.traverse(e=>{let{geometry:t,material:i}=e;t?.dispose();for(let s of Array.isArray(i)?i:[i])s?.dispose()})}function $v(n,e){n.position.set(...e.position),n.quaternion.set(...e.quaternion),n.updateMatrixWorld(!0)}function Ep(n){let[e=1,t=0,i=0,s=0,r=0,o=1,a=0,l=0,c=0,u=0,d=1,h=0]=n;return new Mt().set(e,t,i,s,r,o,a,l,c,u,d,h,0,0,0,1)}function qv(n,e){return n.applyMatrix4(Ep(e)),n}function eC({model:n,body:e,color:t,isSelected:i}){let{size:s,centre:r}=n.body,o=new ti,a=new Zt(...s);e?o.add(Ml(e,!1)):o.add(new Le(a,new qr({color:"#5b6470"})));let l=new pr(new ja(a),new xi({color:on(t),transparent:!i,opacity:i?1:.6}));for(let c of e?[l]:[...o.children,l])c.position.set(...r);return o.add(l),o}function tC(n,e,t){let i=s=>Math.tan(Math.min(s,jA)*Math.PI/360)*t;return[i(n),i(e)]}function Zv(n,e,t){let[i,s]=tC(n,e,t);return[[-i,-s,t],[i,-s,t],[i,s,t],[-i,s,t]]}function Kv(n,e,t,i,s){let r=Zv(n,e,t),o=r.flatMap((l,c)=>[[0,0,0],l,l,r[(c+1)%4]]),a=new Nt().setAttribute("position",new mt(o.flat(),3));return new pr(a,new xi({color:new st(i),transparent:!0,opacity:s}))}function nC(n,{color:e,isSelected:t}){let i=new ti,{hfovDeg:s,vfovDeg:r,minimumM:o,idealM:a,maximumM:l}=n,c=a?.[1]??l??3;i.add(Kv(s,r,c,on(e),t?.55:.25));let u=[[o,Ih.minimum],[a?.[0]??null,Ih.ideal],[a?.[1]??null,Ih.ideal],[l,Ih.maximum]];if(t)for(let[d,h]of u)d!==null&&d>0&&i.add(...iC(s,r,d,h));return i}function iC(n,e,t,i){let s=Zv(n,e,t),r=new Nt().setAttribute("position",new mt(s.flat(),3)),o=r.clone().setIndex([0,1,2,0,2,3]),a=new ji({color:i,transparent:!0,opacity:.05,side:ii,depthWrite:!1});return[new Za(r,new xi({color:i})),new Le(o,a)]}var jr=new xr,xn=new O,Sr=new O,cn=new $t,Jv={X:new O(1,0,0),Y:new O(0,1,0),Z:new O(0,0,1)},Tp={type:"change"},Qv={type:"mouseDown",mode:null},jv={type:"mouseUp",mode:null},ex={type:"objectChange"},Uh=class extends ll{constructor(e,t=null){super(void 0,t);let i=new Cp(this);this._root=i;let s=new Rp;this._gizmo=s,i.add(s);let r=new Pp;this._plane=r,i.add(r);let o=this;function a(E,S){let R=S;Object.defineProperty(o,E,{get:function(){return R!==void 0?R:S},set:function(C){R!==C&&(R=C,r[E]=C,s[E]=C,o.dispatchEvent({type:E+"-changed",value:C}),o.dispatchEvent(Tp))}}),o[E]=S,r[E]=S,s[E]=S}a("camera",e),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),this.viewport=null,a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("showXY",!0),a("showYZ",!0),a("showXZ",!0),a("showXYZE",!0),a("showE",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);let l=new O,c=new O,u=new $t,d=new $t,h=new O,f=new $t,g=new O,y=new O,p=new O,m=0,x=new O;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",u),a("worldQuaternionStart",d),a("cameraPosition",h),a("cameraQuaternion",f),a("pointStart",g),a("pointEnd",y),a("rotationAxis",p),a("rotationAngle",m),a("eye",x),this._offset=new O,this._startNorm=new O,this._endNorm=new O,this._cameraScale=new O,this._parentPosition=new O,this._parentQuaternion=new $t,this._parentQuaternionInv=new $t,this._parentScale=new O,this._worldScaleStart=new O,this._worldQuaternionInv=new $t,this._worldScale=new O,this._positionStart=new O,this._quaternionStart=new $t,this._scaleStart=new O,this._getPointer=sC.bind(this),this._onPointerDown=oC.bind(this),this._onPointerHover=rC.bind(this),this._onPointerMove=aC.bind(this),this._onPointerUp=lC.bind(this),t!==null&&this.connect(t)}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(e){if(this.object===void 0||this.dragging===!0)return;e!==null&&jr.setFromCamera(e,this.camera);let t=Ap(this._gizmo.picker[this.mode],jr);t?this.axis=t.object.name:this.axis=null}pointerDown(e){if(!(this.object===void 0||this.dragging===!0||e!=null&&e.button!==0)&&this.axis!==null){e!==null&&jr.setFromCamera(e,this.camera);let t=Ap(this._plane,jr,!0);t&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(t.point).sub(this.worldPositionStart)),this.dragging=!0,Qv.mode=this.mode,this.dispatchEvent(Qv)}}pointerMove(e){let t=this.axis,i=this.mode,s=this.object,r=this.space;if(i==="scale"?r="local":(t==="E"||t==="XYZE"||t==="XYZ")&&(r="world"),s===void 0||t===null||this.dragging===!1||e!==null&&e.button!==-1)return;e!==null&&jr.setFromCamera(e,this.camera);let o=Ap(this._plane,jr,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),i==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&t!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),t.indexOf("X")===-1&&(this._offset.x=0),t.indexOf("Y")===-1&&(this._offset.y=0),t.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&t!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(cn.copy(this._quaternionStart).invert()),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.getWorldPosition(xn),t.search("X")!==-1&&(xn.x=Math.round(xn.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(xn.y=Math.round(xn.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(xn.z=Math.round(xn.z/this.translationSnap)*this.translationSnap),s.position.copy(s.parent.worldToLocal(xn)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(i==="scale"){if(t.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),Sr.set(a,a,a)}else xn.copy(this.pointStart),Sr.copy(this.pointEnd),xn.applyQuaternion(this._worldQuaternionInv),Sr.applyQuaternion(this._worldQuaternionInv),Sr.divide(xn),t.search("X")===-1&&(Sr.x=1),t.search("Y")===-1&&(Sr.y=1),t.search("Z")===-1&&(Sr.z=1);s.scale.copy(this._scaleStart).multiply(Sr),this.scaleSnap&&(t.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(i==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);let a=20/this.worldPosition.distanceTo(xn.setFromMatrixPosition(this.camera.matrixWorld)),l=!1;t==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(xn.copy(this.rotationAxis).cross(this.eye))*a):(t==="X"||t==="Y"||t==="Z")&&(this.rotationAxis.copy(Jv[t]),xn.copy(Jv[t]),r==="local"&&xn.applyQuaternion(this.worldQuaternion),xn.cross(this.eye),xn.length()===0?l=!0:this.rotationAngle=this._offset.dot(xn.normalize())*a),(t==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&t!=="E"&&t!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(cn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(cn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(Tp),this.dispatchEvent(ex)}}pointerUp(e){e!==null&&e.button!==0||(this.dragging&&this.axis!==null&&(jv.mode=this.mode,this.dispatchEvent(jv)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(e){return this.object=e,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(Tp),this.dispatchEvent(ex),this.pointStart.copy(this.pointEnd))}getRaycaster(){return jr}getMode(){return this.mode}setMode(e){this.mode=e}setTranslationSnap(e){this.translationSnap=e}setRotationSnap(e){this.rotationSnap=e}setScaleSnap(e){this.scaleSnap=e}setSize(e){this.size=e}setSpace(e){this.space=e}setColors(e,t,i,s){let r=this._gizmo.materialLib;r.xAxis.color.set(e),r.yAxis.color.set(t),r.zAxis.color.set(i),r.active.color.set(s),r.xAxisTransparent.color.set(e),r.yAxisTransparent.color.set(t),r.zAxisTransparent.color.set(i),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(e),r.yAxis._color&&r.yAxis._color.set(t),r.zAxis._color&&r.zAxis._color.set(i),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(e),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(t),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(i),r.activeTransparent._color&&r.activeTransparent._color.set(s)}};function sC(n){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:n.button};{let e=this.domElement.getBoundingClientRect(),t=this.viewport,i,s,r,o;return t!==null?(i=t.x,s=e.height-t.y-t.w,r=t.z,o=t.w):(i=0,s=0,r=e.width,o=e.height),{x:(n.clientX-e.left-i)/r*2-1,y:-(n.clientY-e.top-s)/o*2+1,button:n.button}}}function rC(n){if(this.enabled)switch(n.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(n));break}}function oC(n){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(n)),this.pointerDown(this._getPointer(n)))}function aC(n){this.enabled&&this.pointerMove(this._getPointer(n))}function lC(n){this.enabled&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(n)))}function Ap(n,e,t){let i=e.intersectObject(n,!0);for(let s=0;s<i.length;s++)if(i[s].object.visible||t)return i[s];return!1}var Lh=new Qi,qt=new O(0,1,0),tx=new O(0,0,0),nx=new Mt,Dh=new $t,Fh=new $t,Ms=new O,Oh=new Mt,Tl=new O(1,0,0),eo=new O(0,1,0),Al=new O(0,0,1),Nh=new O,wl=new O,El=new O,Cp=class extends ln{constructor(e){super(),this.isTransformControlsRoot=!0,this.controls=e,this.visible=!1}updateMatrixWorld(e){let t=this.controls;t.object!==void 0&&(t.object.updateMatrixWorld(),t.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):t.object.parent.matrixWorld.decompose(t._parentPosition,t._parentQuaternion,t._parentScale),t.object.matrixWorld.decompose(t.worldPosition,t.worldQuaternion,t._worldScale),t._parentQuaternionInv.copy(t._parentQuaternion).invert(),t._worldQuaternionInv.copy(t.worldQuaternion).invert()),t.camera.updateMatrixWorld(),t.camera.matrixWorld.decompose(t.cameraPosition,t.cameraQuaternion,t._cameraScale),t.camera.isOrthographicCamera?t.camera.getWorldDirection(t.eye).negate():t.eye.copy(t.cameraPosition).sub(t.worldPosition).normalize(),this.parent&&(Oh.copy(this.parent.matrixWorld).invert(),Oh.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(e)}dispose(){this.traverse(function(e){e.geometry&&e.geometry.dispose(),e.material&&e.material.dispose()})}},Rp=class extends ln{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";let e=new ji({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),t=new xi({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),i=e.clone();i.opacity=.15;let s=t.clone();s.opacity=.5;let r=e.clone();r.color.setHex(16711680);let o=e.clone();o.color.setHex(65280);let a=e.clone();a.color.setHex(255);let l=e.clone();l.color.setHex(16711680),l.opacity=.5;let c=e.clone();c.color.setHex(65280),c.opacity=.5;let u=e.clone();u.color.setHex(255),u.opacity=.5;let d=e.clone();d.opacity=.25;let h=e.clone();h.color.setHex(16776960),h.opacity=.25;let f=e.clone();f.color.setHex(16776960);let g=e.clone();g.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:f,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:u,activeTransparent:h};let y=new qn(0,.04,.1,12);y.translate(0,.05,0);let p=new Zt(.08,.08,.08);p.translate(0,.04,0);let m=new Nt;m.setAttribute("position",new mt([0,0,0,1,0,0],3));let x=new qn(.0075,.0075,.5,3);x.translate(0,.25,0);function E(W,$){let H=new Gs(W,.0075,3,64,$*Math.PI*2);return H.rotateY(Math.PI/2),H.rotateX(Math.PI/2),H}function S(){let W=new Nt;return W.setAttribute("position",new mt([0,0,0,1,1,1],3)),W}let R={X:[[new Le(y,r),[.5,0,0],[0,0,-Math.PI/2]],[new Le(y,r),[-.5,0,0],[0,0,Math.PI/2]],[new Le(x,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new Le(y,o),[0,.5,0]],[new Le(y,o),[0,-.5,0],[Math.PI,0,0]],[new Le(x,o)]],Z:[[new Le(y,a),[0,0,.5],[Math.PI/2,0,0]],[new Le(y,a),[0,0,-.5],[-Math.PI/2,0,0]],[new Le(x,a),null,[Math.PI/2,0,0]]],XYZ:[[new Le(new mr(.1,0),d),[0,0,0]]],XY:[[new Le(new Zt(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new Le(new Zt(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Le(new Zt(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},C={X:[[new Le(new qn(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Le(new qn(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Le(new qn(.2,0,.6,4),i),[0,.3,0]],[new Le(new qn(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Le(new qn(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Le(new qn(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new Le(new mr(.2,0),i)]],XY:[[new Le(new Zt(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Le(new Zt(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Le(new Zt(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]]},v={START:[[new Le(new mr(.01,2),s),null,null,null,"helper"]],END:[[new Le(new mr(.01,2),s),null,null,null,"helper"]],DELTA:[[new ni(S(),s),null,null,null,"helper"]],X:[[new ni(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new ni(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new ni(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},w={XYZE:[[new Le(E(.5,1),g),null,[0,Math.PI/2,0]]],X:[[new Le(E(.5,.5),r)]],Y:[[new Le(E(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new Le(E(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new Le(E(.75,1),h),null,[0,Math.PI/2,0]]]},U={AXIS:[[new ni(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},I={XYZE:[[new Le(new Xr(.25,10,8),i)]],X:[[new Le(new Gs(.5,.1,4,24),i),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new Le(new Gs(.5,.1,4,24),i),[0,0,0],[Math.PI/2,0,0]]],Z:[[new Le(new Gs(.5,.1,4,24),i),[0,0,0],[0,0,-Math.PI/2]]],E:[[new Le(new Gs(.75,.1,2,24),i)]]},D={X:[[new Le(p,r),[.5,0,0],[0,0,-Math.PI/2]],[new Le(x,r),[0,0,0],[0,0,-Math.PI/2]],[new Le(p,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new Le(p,o),[0,.5,0]],[new Le(x,o)],[new Le(p,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new Le(p,a),[0,0,.5],[Math.PI/2,0,0]],[new Le(x,a),[0,0,0],[Math.PI/2,0,0]],[new Le(p,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new Le(new Zt(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new Le(new Zt(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Le(new Zt(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Le(new Zt(.1,.1,.1),d)]]},z={X:[[new Le(new qn(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Le(new qn(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Le(new qn(.2,0,.6,4),i),[0,.3,0]],[new Le(new qn(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Le(new qn(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Le(new qn(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new Le(new Zt(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Le(new Zt(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Le(new Zt(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Le(new Zt(.2,.2,.2),i),[0,0,0]]]},G={X:[[new ni(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new ni(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new ni(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function N(W){let $=new ln;for(let H in W)for(let le=W[H].length;le--;){let Y=W[H][le][0].clone(),j=W[H][le][1],ie=W[H][le][2],he=W[H][le][3],de=W[H][le][4];Y.name=H,Y.tag=de,j&&Y.position.set(j[0],j[1],j[2]),ie&&Y.rotation.set(ie[0],ie[1],ie[2]),he&&Y.scale.set(he[0],he[1],he[2]),Y.updateMatrix();let ee=Y.geometry.clone();ee.applyMatrix4(Y.matrix),Y.geometry=ee,Y.renderOrder=1/0,Y.position.set(0,0,0),Y.rotation.set(0,0,0),Y.scale.set(1,1,1),$.add(Y)}return $}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=N(R)),this.add(this.gizmo.rotate=N(w)),this.add(this.gizmo.scale=N(D)),this.add(this.picker.translate=N(C)),this.add(this.picker.rotate=N(I)),this.add(this.picker.scale=N(z)),this.add(this.helper.translate=N(v)),this.add(this.helper.rotate=N(U)),this.add(this.helper.scale=N(G)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(e){let i=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:Fh;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){let o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(cn.setFromEuler(Lh.set(0,0,0)),o.quaternion.copy(i).multiply(cn),Math.abs(qt.copy(Tl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(cn.setFromEuler(Lh.set(0,0,Math.PI/2)),o.quaternion.copy(i).multiply(cn),Math.abs(qt.copy(eo).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(cn.setFromEuler(Lh.set(0,Math.PI/2,0)),o.quaternion.copy(i).multiply(cn),Math.abs(qt.copy(Al).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(cn.setFromEuler(Lh.set(0,Math.PI/2,0)),qt.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(nx.lookAt(tx,qt,eo)),o.quaternion.multiply(cn),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),xn.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),xn.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(xn),o.visible=this.dragging):(o.quaternion.copy(i),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(i),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(qt.copy(Tl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(qt.copy(eo).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(qt.copy(Al).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(qt.copy(Al).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(qt.copy(Tl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(qt.copy(eo).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(Dh.copy(i),qt.copy(this.eye).applyQuaternion(cn.copy(i).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(nx.lookAt(this.eye,tx,eo)),o.name==="X"&&(cn.setFromAxisAngle(Tl,Math.atan2(-qt.y,qt.z)),cn.multiplyQuaternions(Dh,cn),o.quaternion.copy(cn)),o.name==="Y"&&(cn.setFromAxisAngle(eo,Math.atan2(qt.x,qt.z)),cn.multiplyQuaternions(Dh,cn),o.quaternion.copy(cn)),o.name==="Z"&&(cn.setFromAxisAngle(Al,Math.atan2(qt.y,qt.x)),cn.multiplyQuaternions(Dh,cn),o.quaternion.copy(cn))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.visible=o.visible&&(o.name.indexOf("XY")===-1||this.showXY),o.visible=o.visible&&(o.name.indexOf("YZ")===-1||this.showYZ),o.visible=o.visible&&(o.name.indexOf("XZ")===-1||this.showXZ),o.visible=o.visible&&(o.name!=="E"||this.showE),o.visible=o.visible&&(o.name!=="XYZE"||this.showXYZE),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(e)}},Pp=class extends Le{constructor(){super(new Wr(1e5,1e5,2,2),new ji({visible:!1,wireframe:!0,side:ii,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(e){let t=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(t="local"),Nh.copy(Tl).applyQuaternion(t==="local"?this.worldQuaternion:Fh),wl.copy(eo).applyQuaternion(t==="local"?this.worldQuaternion:Fh),El.copy(Al).applyQuaternion(t==="local"?this.worldQuaternion:Fh),qt.copy(wl),this.mode){case"translate":case"scale":switch(this.axis){case"X":qt.copy(this.eye).cross(Nh),Ms.copy(Nh).cross(qt);break;case"Y":qt.copy(this.eye).cross(wl),Ms.copy(wl).cross(qt);break;case"Z":qt.copy(this.eye).cross(El),Ms.copy(El).cross(qt);break;case"XY":Ms.copy(El);break;case"YZ":Ms.copy(Nh);break;case"XZ":qt.copy(El),Ms.copy(wl);break;case"XYZ":case"E":Ms.set(0,0,0);break}break;default:Ms.set(0,0,0)}Ms.length()===0?this.quaternion.copy(this.cameraQuaternion):(Oh.lookAt(xn.set(0,0,0),Ms,qt),this.quaternion.setFromRotationMatrix(Oh)),super.updateMatrixWorld(e)}};var kh=class{controls;handle=new ln;constructor(e,t,i,s,r,o){this.controls=new Uh(e,t),this.controls.setSize(.7),i.add(this.handle,this.controls.getHelper()),this.controls.addEventListener("change",o),this.controls.addEventListener("dragging-changed",({value:a})=>{s.isEnabled=!a}),this.controls.addEventListener("objectChange",()=>{let{x:a,y:l,z:c}=this.handle.position,{x:u,y:d,z:h,w:f}=this.handle.quaternion;r({position:[a,l,c],quaternion:[u,d,h,f]})})}get isActive(){return this.controls.dragging||this.controls.axis!==null}set(e,t){if(e==="none"||!t){this.controls.detach();return}this.controls.setMode(e),this.controls.setSpace(e==="translate"?"world":"local"),this.controls.dragging||(this.handle.position.set(...t.position),this.handle.quaternion.set(...t.quaternion),this.handle.updateMatrixWorld()),this.controls.object!==this.handle&&this.controls.attach(this.handle)}};var cC=.02,ix=.01,la=6,sx="#d6409f",uC="#ffffff",Bh=class{constructor(e,t,i,s,r,o){this.canvas=e;this.navigation=i;this.ray=s;this.onBox=r;this.onChange=o;this.handles=Array.from({length:la+1},(a,l)=>{let c=new ji({color:sx,depthTest:!1,transparent:!0,opacity:.9}),u=new Le(l===la?new Xr(.75,16,12):new Zt(1,1,1),c);return u.renderOrder=11,u}),this.group.add(...this.handles),this.group.visible=!1,t.add(this.group),e.addEventListener("pointermove",a=>this.hover(a)),e.addEventListener("pointerdown",a=>this.grab(a))}canvas;navigation;ray;onBox;onChange;group=new ti;handles;box=null;up="z";hovered=-1;drag=null;get isActive(){return this.hovered>=0||this.drag!==null}set(e,t){this.box=e,this.up=t,this.group.visible=e!==null,e||(this.hovered=-1),this.handles.forEach((i,s)=>e&&i.position.copy(ox(e,s)))}fit(e){if(this.box)for(let t of this.handles)t.scale.setScalar(cC*e.position.distanceTo(t.position))}find(e){if(!this.box)return-1;let t=this.ray(e.clientX,e.clientY).intersectObjects(this.handles);return this.handles.findIndex(i=>i===t[0]?.object)}hover(e){if(this.drag||e.buttons!==0)return;let t=this.find(e);t!==this.hovered&&(this.hovered=t,this.canvas.style.cursor=t>=0?"grab":"",this.handles.forEach((i,s)=>i.material.color.set(s===t?uC:sx)),this.onChange())}grab(e){let t=e.button===0?this.find(e):-1;if(t<0||!this.box)return;let i={handle:t,box:this.box,from:new O,isVertical:e.shiftKey},s=this.reach(e,i);if(!s)return;this.drag={...i,from:s},this.navigation.isEnabled=!1;let r=a=>this.move(a),o=()=>{this.drag=null,this.navigation.isEnabled=!0,removeEventListener("pointermove",r),removeEventListener("pointerup",o),removeEventListener("pointercancel",o)};addEventListener("pointermove",r),addEventListener("pointerup",o),addEventListener("pointercancel",o)}move(e){let{drag:t}=this,i=t&&this.reach(e,t);if(!t||!i)return;let s=i.sub(t.from).toArray(),r=[[...t.box[0]],[...t.box[1]]];if(t.handle===la)for(let o of r)o.forEach((a,l)=>o[l]=a+(s[l]??0));else{let[o,a]=[t.handle>>1,t.handle&1],[l,c]=[t.box[0][o]??0,t.box[1][o]??0],u=(a?c:l)+(s[o]??0);r[a][o]=a?Math.max(u,l+ix):Math.min(u,c-ix)}this.onBox(r.map(o=>o.map(a=>Number(a.toFixed(4)))))}reach(e,{handle:t,box:i,isVertical:s}){let{ray:r}=this.ray(e.clientX,e.clientY),o=ox(i,t),a=this.up==="z"?2:1;return t!==la||s?hC(r.origin,r.direction,o,rx(t===la?a:t>>1)):r.intersectPlane(new di().setFromNormalAndCoplanarPoint(rx(a),o),new O)}};function rx(n){return new O().setComponent(n,1)}function ox([n,e],t){let i=new O(...n).add(new O(...e)).multiplyScalar(.5);return t!==la&&i.setComponent(t>>1,(t&1?e:n)[t>>1]??0),i}function hC(n,e,t,i){let s=n.clone().sub(t),r=i.dot(e),o=1-r*r;if(o<1e-4)return null;let a=(i.dot(s)-r*e.dot(s))/o;return t.clone().addScaledVector(i,a)}var zh=.006,dC=1.0015,Vh=Math.PI/2-.02,ax={KeyW:[1,0,0],KeyS:[-1,0,0],KeyA:[0,1,0],KeyD:[0,-1,0],KeyE:[0,0,1],KeyQ:[0,0,-1]},Gh=class{constructor(e,t,i){this.camera=e;this.element=t;this.onChange=i;t.addEventListener("pointerdown",s=>this.grab(s)),t.addEventListener("wheel",s=>this.zoom(s),{passive:!1}),t.addEventListener("contextmenu",s=>s.preventDefault()),t.addEventListener("keydown",s=>this.press(s)),t.addEventListener("keyup",s=>this.keys.delete(s.code)),t.addEventListener("blur",()=>this.keys.clear())}camera;element;onChange;isEnabled=!0;up="z";target=new O;distance=5;azimuth=0;elevation=.4;keys=new Set;isFast=!1;lastTime=0;look(e,t,i){this.up=e,this.camera.up.copy(this.world(0,0,1)),this.target.copy(t);let s=i.clone().sub(t);this.distance=Math.max(s.length(),.05);let[r,o,a]=this.local(s.normalize());this.azimuth=Math.atan2(o,r),this.elevation=Math.asin(Math.max(-1,Math.min(1,a))),this.apply()}lookAlong(e){let t=new O(...e.position),i=new O(...Aa(e.quaternion,[1,0,0]));this.look(this.up,t.clone().addScaledVector(i,2),t)}focus(e,t){this.target.copy(e),this.distance=t,this.apply()}world(e,t,i){return this.up==="z"?new O(e,t,i):new O(e,i,-t)}local({x:e,y:t,z:i}){return this.up==="z"?[e,t,i]:[e,-i,t]}outward(){let e=Math.cos(this.elevation);return this.world(e*Math.cos(this.azimuth),e*Math.sin(this.azimuth),Math.sin(this.elevation))}apply(){this.elevation=Math.max(-Vh,Math.min(Vh,this.elevation)),this.camera.position.copy(this.target).addScaledVector(this.outward(),this.distance),this.camera.lookAt(this.target),this.camera.updateMatrixWorld(),this.onChange()}grab(e){if(!this.isEnabled)return;this.element.focus({preventScroll:!0});let t=e.button!==0||e.shiftKey,i=e.ctrlKey||e.altKey,[s,r]=[e.clientX,e.clientY],o=l=>{if(!this.isEnabled)return;let[c,u]=[l.clientX-s,l.clientY-r];[s,r]=[l.clientX,l.clientY],t?this.pan(c,u):i?this.turnHead(c,u):this.orbit(c,u)},a=()=>{removeEventListener("pointermove",o),removeEventListener("pointerup",a),removeEventListener("pointercancel",a)};addEventListener("pointermove",o),addEventListener("pointerup",a),addEventListener("pointercancel",a)}orbit(e,t){this.azimuth-=e*zh,this.elevation+=t*zh,this.apply()}turnHead(e,t){let i=this.camera.position.clone();this.azimuth-=e*zh*.5,this.elevation=Math.max(-Vh,Math.min(Vh,this.elevation+t*zh*.5)),this.target.copy(i).addScaledVector(this.outward(),-this.distance),this.apply()}pan(e,t){let i=2*this.distance*Math.tan(this.camera.fov*Math.PI/360)/this.element.clientHeight,s=new O().setFromMatrixColumn(this.camera.matrixWorld,0),r=new O().setFromMatrixColumn(this.camera.matrixWorld,1);this.target.addScaledVector(s,-e*i).addScaledVector(r,t*i),this.apply()}zoom(e){e.preventDefault();let t=e.deltaMode===WheelEvent.DOM_DELTA_LINE?30:1;this.distance=Math.min(500,Math.max(.05,this.distance*dC**(e.deltaY*t))),this.apply()}press(e){if(this.isFast=e.shiftKey,e.ctrlKey||e.metaKey||e.altKey||!(e.code in ax))return;e.preventDefault();let t=this.keys.size===0;this.keys.add(e.code),t&&(this.lastTime=performance.now(),requestAnimationFrame(()=>this.fly()))}fly(){if(this.keys.size===0)return;let e=performance.now(),t=Math.min((e-this.lastTime)/1e3,.1);this.lastTime=e;let i=Math.max(.4,this.distance*.6)*(this.isFast?3:1)*t,s=this.outward().negate(),r=new O().setFromMatrixColumn(this.camera.matrixWorld,0);for(let o of this.keys){let[a,l,c]=ax[o]??[0,0,0];this.target.addScaledVector(s,a*i).addScaledVector(r,-l*i).add(this.world(0,0,c*i))}this.apply(),requestAnimationFrame(()=>this.fly())}};var fC=.03,lx="#ff2d78",pC=4,Hh=class{constructor(e,t){this.canvas=e;this.renderer=new Ch({canvas:e,antialias:!1,powerPreference:"high-performance"}),this.renderer.localClippingEnabled=!0,this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.scene.add(new nl("#ffffff","#8a8f98",1.9),this.lamp,this.oaks,this.clouds);let i=()=>this.invalidate();this.navigation=new Gh(this.camera,e,()=>{this.invalidate(),t.onView()}),this.gizmo=new kh(this.camera,e,this.scene,this.navigation,t.onPose,i);let s=(r,o)=>this.caster(r,o);this.box=new Bh(e,this.scene,this.navigation,s,t.onBox,i),this.marker=new Hr(new Nt().setAttribute("position",new mt([0,0,0],3)),new jo({color:lx,size:9,sizeAttenuation:!1,depthTest:!1,transparent:!0})),this.sight=new ni(new Nt().setAttribute("position",new mt([0,0,0,0,0,0],3)),new xi({color:lx,transparent:!0,opacity:.7,depthTest:!1}));for(let r of[this.marker,this.sight])r.visible=!1,r.frustumCulled=!1,r.renderOrder=10,this.scene.add(r);this.observer=new ResizeObserver(()=>this.resize()),this.observer.observe(e),this.listenForClicks(t)}canvas;drawn=0;pace=0;navigation;gizmo;renderer;scene=new qa;camera=new fi(50,1,.02,1e3);oaks=new ti;clouds=new ti;marker;sight;lamp=new rl("#ffffff",1.6);observer;mesh=null;grid=null;target=null;painting=null;box;objects=null;isWaiting=!1;lastDraw=0;close(){this.observer.disconnect(),Qr(this.scene),this.renderer.dispose()}invalidate(){if(this.isWaiting)return;this.isWaiting=!0;let e=this.lastDraw+this.pace-performance.now();e>0?setTimeout(()=>this.draw(),e):this.draw()}get isSoftware(){let e=this.renderer.getContext(),t=e.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|softpipe|basic render/i.test(String(e.getParameter(t?t.UNMASKED_RENDERER_WEBGL:e.RENDERER)))}draw(){requestAnimationFrame(()=>{this.isWaiting=!1,this.lastDraw=performance.now(),this.lamp.position.copy(this.camera.position),this.box.fit(this.camera),this.renderer.render(this.scene,this.camera),this.drawn++})}get isIdle(){return!this.isWaiting}setBackground(e,t){this.scene.background=new st(e),this.grid&&this.grid.material.color.set(t),this.invalidate()}setScene(e,t,i){this.mesh&&(this.scene.remove(this.mesh),Qr(this.mesh)),this.mesh=Ml(t,i),this.objects=t.objects,this.scene.add(this.mesh);let s=new O(...e.bounds[1]).distanceTo(new O(...e.bounds[0]));this.camera.near=Math.min(.05,Math.max(s/5e3,.001)),this.camera.far=Math.max(100,s*10),this.camera.updateProjectionMatrix(),this.invalidate()}showScene(e){this.mesh&&(this.mesh.visible=e),this.invalidate()}roofAbove(e,t){if(!this.mesh)return null;let i=new O(...lc(e.up)),s=new xr(new O(...t),i).intersectObject(this.mesh)[0];return s?s.point.dot(i):null}setRoof(e,t){if(!this.mesh)return;let i=new O(...lc(e.up)).negate();this.mesh.material.clippingPlanes=t===null?null:[new di(i,t-fC)],this.painting&&(this.painting.material.clippingPlanes=this.mesh.material.clippingPlanes),this.invalidate()}setGrid(e,t,i){if(this.grid&&(this.scene.remove(this.grid),Qr(this.grid),this.grid=null),t){let[s,r]=e.bounds,[o,a]=e.up==="z"?[r[0]-s[0],r[1]-s[1]]:[r[0]-s[0],r[2]-s[2]],l=Math.min(100,Math.max(4,2*Math.ceil(Math.max(o,a)/2)+2));this.grid=new ol(l,l,i,i),e.up==="z"&&(this.grid.rotation.x=Math.PI/2);let c=new O(...s).add(new O(...r)).multiplyScalar(.5).round();e.up==="z"?c.z=s[2]-.01:c.y=s[1]-.01,this.grid.position.copy(c),this.scene.add(this.grid)}this.invalidate()}setOaks(e){Qr(this.oaks),this.oaks.clear(),e.length&&this.oaks.add(...e),this.invalidate()}setClouds(e){Qr(this.clouds),this.clouds.clear(),e.length&&this.clouds.add(...e),this.invalidate()}setMarker(e,t){if(this.marker.visible=e!==null,this.sight.visible=e!==null&&t!==null,e&&this.marker.position.set(...e),e&&t){let i=this.sight.geometry.getAttribute("position");i.setXYZ(0,...t),i.setXYZ(1,...e),i.needsUpdate=!0}this.invalidate()}setPainting(e,t){this.painting&&(this.scene.remove(this.painting),Qr(this.painting),this.painting=null),e&&(this.painting=Xv(e,t),this.painting.material.clippingPlanes=this.mesh?.material.clippingPlanes??null,this.scene.add(this.painting)),this.invalidate()}setTarget(e,t,i){if(this.box.set(t?e:null,i),this.target&&(this.scene.remove(this.target),this.target.dispose(),this.target=null),e){let s=new gs(new O(...e[0]),new O(...e[1]));this.target=new al(s,new st("#d6409f")),this.scene.add(this.target)}this.invalidate()}setGizmo(e,t){this.gizmo.set(e,t),this.invalidate()}lookAt(e,t,i){let s=new O(...lc(e.up)),[r,o]=[new O(...e.bounds[0]),new O(...e.bounds[1])],a=new O(...t.position),l=Math.min(Math.max(r.distanceTo(o),1),8),c=new O(1,0,0).applyQuaternion(this.oaks.quaternion.clone().set(...t.quaternion));c.addScaledVector(s,-c.dot(s)),c.length()<.1&&c.set(1,0,0),c.normalize();let u=new O().crossVectors(s,c),d=a.clone().addScaledVector(c,l*.2),[h,f,g]=i?[.12,.12,.62]:[.3,.22,.25],y=a.clone().addScaledVector(c,-l*h).addScaledVector(u,-l*f).addScaledVector(s,l*g);this.navigation.look(e.up,d,y)}pose(){let e=new Mt().makeBasis(new O(0,0,-1),new O(-1,0,0),new O(0,1,0)),{x:t,y:i,z:s,w:r}=this.camera.quaternion.clone().multiply(new $t().setFromRotationMatrix(e));return{position:this.camera.position.toArray(),quaternion:[t,i,s,r]}}hit(e,t){if(!this.mesh?.visible)return null;let i=this.mesh.material.clippingPlanes??[],r=this.caster(e,t).intersectObject(this.mesh).find(({point:o})=>i.every(a=>a.distanceToPoint(o)>=0));return!r||r.faceIndex==null?null:{point:r.point,object:this.objects?.[r.faceIndex]??0}}caster(e,t){let{left:i,top:s,width:r,height:o}=this.canvas.getBoundingClientRect(),a=new xr;return a.setFromCamera(new ct((e-i)/r*2-1,1-(t-s)/o*2),this.camera),a}oakAt(e,t,i){let s=this.caster(e,t),r=i?s.ray.origin.distanceTo(i):Number.POSITIVE_INFINITY,o=this.oaks.children.map(c=>c.children[0]).filter(c=>c!==void 0),a=s.intersectObjects(o).find(({object:c,distance:u})=>c.isMesh&&u<r),l=o.findIndex(c=>a&&(c===a.object||c===a.object.parent));return l<0?null:l}listenForClicks({onPick:e,onOak:t}){let i=null;this.canvas.addEventListener("pointerdown",s=>{i=s.button===0&&!this.gizmo.isActive&&!this.box.isActive?[s.clientX,s.clientY]:null}),this.canvas.addEventListener("pointerup",s=>{if(!i||Math.hypot(s.clientX-i[0],s.clientY-i[1])>pC)return;let r=this.hit(s.clientX,s.clientY),o=this.oakAt(s.clientX,s.clientY,r?.point??null);o===null?e(r?.object??null):t(o)}),this.canvas.addEventListener("dblclick",s=>{let r=this.hit(s.clientX,s.clientY);r&&this.navigation.focus(r.point,Math.max(.3,this.camera.position.distanceTo(r.point)*.5))})}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e===0||t===0||(this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.invalidate())}};var mC=400,cx={mesh:null,error:null},Wh=class extends Bt{constructor(t){super(cx);this.studio=t;for(let i of[t.document,t.display,t.connection,t.scene])i.subscribe(()=>this.follow());this.follow()}studio;wanted=[];running=null;timer=0;get isIdle(){return this.timer===0&&this.running===null}follow(){let{document:t,display:i,connection:s,scene:r}=this.studio,{target:o,scene:a}=t.get(),l=Fn(t.get()),u=i.get().paintsCoverage&&o!==null&&l!==void 0&&this.studio.hasDepth(l.state)&&r.get()?.id===a&&s.get()==="open"?[a,o,l.state]:[];u.length===this.wanted.length&&u.every((d,h)=>d===this.wanted[h])||(this.wanted=u,this.running?.abort(),this.running=null,clearTimeout(this.timer),this.timer=0,l&&u.length?this.timer=window.setTimeout(()=>{this.paint(l)},mC):this.set(cx))}async paint(t){this.timer=0;let{scene:i,target:s}=this.studio.document.get();if(!s)return;let r=new AbortController;this.running=r;try{let o=await hn.surface({scene:i,state:t.state,region:s},r.signal);this.running===r&&this.set({mesh:o,error:null})}catch(o){this.running===r&&this.set({mesh:null,error:o instanceof Error?o.message:String(o)})}finally{this.running===r&&(this.running=null)}}};var gC=1e5,_C=5e6,vC=3e5,xC=150,yC=30,Xh=class{constructor(e,t){this.studio=e;this.viewer=new Hh(t,{onPose:l=>this.movePose(l),onPick:l=>this.pick(l),onOak:l=>this.select(l),onView:()=>this.ride(),onBox:([l,c])=>e.document.commit("target box",u=>({...u,target:{minimum:l,maximum:c}}))}),this.painting=new Wh(e),this.painting.subscribe(()=>this.viewer.setPainting(this.painting.get().mesh,xa));let{document:i,display:s,scene:r,frames:o,probe:a}=e;r.subscribe(()=>{this.loadScene()});for(let l of[i,s,this.gizmo,this.isRiding])l.subscribe(()=>this.follow());o.subscribe(()=>this.followClouds()),a.subscribe(()=>this.followProbe()),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.paintBackground()),this.follow(),this.loadScene()}studio;gizmo=new Bt("translate");isPicking=new Bt(!1);isRiding=new Bt(!1);detail=new Bt(null);viewer;painting;bodies=new Map;groups=[];seen=new Map;hasClouds=!1;mesh=null;loaded="";wantsDetail=!1;ridden=0;roof=null;get isIdle(){return this.viewer.isIdle&&this.painting.isIdle}home(){let[e,t]=[this.studio.scene.get(),Fn(this.studio.document.get())];e&&t&&this.viewer.lookAt(e,t.state.pose,this.roof!==null&&!this.studio.display.get().showRoof)}lookThrough(){let e=Fn(this.studio.document.get());e&&this.viewer.navigation.lookAlong(e.state.pose)}setRiding(e){e&&this.lookThrough(),this.viewer.pace=e&&this.viewer.isSoftware?xC:0,this.isRiding.set(e)}loadFullDetail(){this.wantsDetail=!0,this.loaded="",this.loadScene()}paintBackground(){let e=getComputedStyle(document.documentElement),{scene:t,display:i}=this.studio,s=e.getPropertyValue("--grid").trim();this.viewer.setBackground(e.getPropertyValue("--view").trim(),s);let r=t.get();r&&this.viewer.setGrid(r,i.get().showGrid,s)}async loadScene(){let e=this.studio.scene.get();if(e||(this.loaded=""),!e||e.id===this.loaded)return;let t=this.isNew("place",e.id,...e.bounds.flat());this.loaded=e.id;try{let i=await hn.sceneMesh(e.id,this.wantsDetail?_C:gC);if(this.wantsDetail=!1,this.studio.scene.get()?.id!==e.id)return;this.viewer.setScene(e,i,!1),this.mesh=i,this.detail.set({shown:i.header.triangles,of:i.header.ofTriangles}),t&&(this.roof=this.viewer.roofAbove(e,e.pose.position)),t&&this.home(),this.follow()}catch(i){this.loaded="",this.studio.connection.get()==="open"&&this.studio.report("The 3D view",i)}}follow(){let{document:e,display:t,scene:i}=this.studio,[s,r,o]=[t.get(),e.get(),i.get()];this.followOaks(r.oaks,r.selected,s);let[a,l]=[this.isRiding.get()?"none":this.gizmo.get(),Fn(r)?.state.pose??null];this.isNew("gizmo",a,l)&&this.viewer.setGizmo(a,l),this.isNew("scene",this.mesh,s.showScene)&&this.viewer.showScene(s.showScene);let c=s.showRoof?null:this.roof;if(o&&this.isNew("roof",this.mesh,c)&&this.viewer.setRoof(o,c),this.isNew("target",r.target,o)){let u=r.target!==null&&"minimum"in r.target;this.viewer.setTarget(Ip(r.target,o),u,o?.up??"z")}this.isNew("background",o,s.showGrid,s.theme)&&this.paintBackground(),this.followClouds()}isNew(e,...t){let i=this.seen.get(e);return this.seen.set(e,t),!i||i.length!==t.length||t.some((s,r)=>s!==i[r])}followOaks(e,t,i){let s=e.filter(a=>!a.isHidden),r=this.isRiding.get(),o=JSON.stringify([t,r,i.showCameras,i.showRanges,s.map(({key:a,state:l})=>[a,l.model,l.sensor,this.bodies.get(l.model)?1:0]),e.map(({key:a})=>a)]);if(this.isNew("looks",o)&&(this.groups=s.flatMap(a=>this.makeGroup(a,e.indexOf(a),a.key===t,i)),this.viewer.setOaks(this.groups.map(({group:a})=>a))),!!this.isNew("poses",o,...s.map(({state:a})=>a.pose))){for(let a of this.groups){let l=e.find(({key:u})=>u===a.oak.key);l&&$v(a.group,l.state.pose);let{arePosesLinked:c}=this.studio.document.get();a.group.visible=!r||a.oak.key!==t&&!c}this.viewer.invalidate()}}makeGroup(e,t,i,s){let r=this.studio.catalog.get(),o=gi(r,e.state.model);if(!o)return[];this.loadBody(o.name);let a=Yv({model:o,sensor:_i(r,e.state),body:this.bodies.get(o.name)??null,color:Qn(t),isSelected:i,showCameras:s.showCameras,showRanges:s.showRanges});return[{oak:e,group:a}]}async loadBody(e){if(!this.bodies.has(e)){this.bodies.set(e,null);try{this.bodies.set(e,await hn.body(e)),this.follow()}catch{}}}followClouds(){let{studio:e}=this,t=e.display.get(),i=e.frames.get(),{depthMap:s,depthRange:r,errorRange:o,errorUnit:a,cloud:l,cloudColor:c}=t;if(l==="none"&&!this.hasClouds||!this.isNew("clouds",s,r,o,a,l,c,...i.values()))return;this.hasClouds=l!=="none";let u=e.document.get().oaks;this.viewer.setClouds(l==="none"?[]:[...i].flatMap(([d,h])=>this.makeClouds(h,u.findIndex(({key:f})=>f===d),t,i)))}makeClouds(e,t,i,s){let r=_i(this.studio.catalog.get(),e.state);if(!r)return[];let{pictures:o,header:a}=e,l=o.get("reference")??o.get("depth"),c=o.get("sensor"),u=i.cloud==="both"?[l,c]:[i.cloud==="truth"?l:c],d=oc(s.values(),i),h=i.cloudColor,[f,g,y]=Qn(Math.max(t,0)),p=new Mt().compose(new O(...e.state.pose.position),new $t(...e.state.pose.quaternion),new O(1,1,1));return u.filter(m=>m!==void 0).map(m=>{let x=i.cloud==="both"&&m===l,E=Hv({depth:m,truth:l,measured:c,reasons:o.get("reason"),hfovDeg:a.hfovDeg,vfovDeg:a.vfovDeg,mode:x?"oak":h,table:h==="error"?po():h==="reason"?Gl():fo(i.depthMap),range:h==="error"?[0,d.error]:d.depth,isRelative:i.errorUnit==="%",color:x?[.62,.64,.68]:[f/255,g/255,y/255],pointSize:2,maxPoints:vC/(s.size*u.length)});return Wv(E,p,Ep(r.bodyFromCamera)),E})}followProbe(){let{probe:e,frames:t,catalog:i}=this.studio,s=e.get(),r=s&&t.get().get(s.oak),o=r&&_i(i.get(),r.state);if(!s?.point||!r||!o)return this.viewer.setMarker(null,null);let a=o.bodyFromCamera,l=new O(a[3],a[7],a[11]).applyQuaternion(new $t(...r.state.pose.quaternion));this.viewer.setMarker(s.point,l.add(new O(...r.state.pose.position)).toArray())}ride(){!this.isRiding.get()||this.ridden||(this.ridden=window.setTimeout(()=>{this.ridden=0,this.isRiding.get()&&this.movePose(this.viewer.pose())},yC))}movePose(e){this.studio.change("pose",t=>({...t,pose:e}))}select(e){let t=this.groups[e]?.oak.key;t&&this.studio.document.set({...this.studio.document.get(),selected:t})}pick(e){if(!this.isPicking.get())return;let t=e===null?void 0:this.studio.scene.get()?.objects[e];t&&(this.isPicking.set(!1),this.studio.document.commit("target",i=>({...i,target:{object:t.path}})))}};function Ip(n,e){if(!n)return null;if("minimum"in n)return[n.minimum,n.maximum];let t=e?.objects.filter(({path:s})=>s===n.object||s.startsWith(`${n.object}/`))??[],[i]=t;return i?t.reduce(([s,r],{bounds:o})=>[s.map((a,l)=>Math.min(a,o[0][l]??a)),r.map((a,l)=>Math.max(a,o[1][l]??a))],i.bounds):null}var qh=60;function ux({from:n,to:e,count:t}){return t<=1?[n]:Array.from({length:t},(i,s)=>n+(e-n)*s/(t-1))}function Yh(n,e){return n.pose.position[e==="z"?2:1]}function hx(n,e,t,i){return n.flatMap(s=>ux(e).flatMap(r=>ux(t).map(o=>{let a=uc(s.pose,[0,0,r-Yh(s,i)],i),l=hc(a,{pitch:o-ds(a.quaternion,i).pitch},i);return{...s,pose:l}})))}function dx(n,e,t){let i=n.flatMap((r,o)=>{let a=e.poses[o];return a?[{state:r,heightM:Yh(r,t),tiltDeg:ds(r.pose.quaternion,t).pitch,coverage:a}]:[]}),s=({coverage:r})=>r.medianAbsoluteErrorM??Number.POSITIVE_INFINITY;return i.sort((r,o)=>o.coverage.measured-r.coverage.measured||s(r)-s(o))}var bC=3,SC=12;function px({target:n}){let{studio:e}=He(),t=Ae(e.document),i=Ae(e.scene)?.up??"z",s=Fn(t),r=s?Yh(s.state,i):1,[o,a]=Pt(()=>({from:Number((r-.5).toFixed(2)),to:Number((r+.5).toFixed(2)),count:5})),[l,c]=Pt(()=>{let v=s?Math.round(ds(s.state.pose.quaternion,i).pitch):0;return{from:v-20,to:v+20,count:3}}),[u,d]=Pt(!1),[h,f]=Pt(null),[g,y]=Pt(null),p=Tt(null),[m,x]=Pt(null);if(Ht(()=>()=>p.current?.abort(),[]),!s)return null;let E=u?t.oaks.filter(v=>!v.isHidden&&e.hasDepth(v.state)).map(({state:v})=>v):[s.state],S=o.count*l.count*E.length,R=async()=>{let v=hx(E,o,l,i),w=new AbortController;p.current=w,y(null);let U=[];try{for(;U.length<v.length;){x(U.length);let I=v.slice(U.length,U.length+bC);U.push(...(await hn.coverage({scene:t.scene,states:I,region:n},w.signal)).poses),f(dx(v,{poses:U},i))}}catch(I){w.signal.aborted||y(I instanceof Error?I.message:String(I))}finally{x(null)}},C=({state:v})=>e.document.commit("sweep",w=>nr(w,w.selected,U=>({...U,pose:v.pose})));return _(en,{title:"Sweep",testId:"sweep",children:[_(fx,{name:"Height",unit:"m",span:o,onChange:a}),_(fx,{name:"Tilt",unit:"°",span:l,onChange:c}),t.oaks.length>1&&_(Wi,{label:"All models, not only the selected OAK",isOn:u,onChange:d}),_("div",{class:"row",children:[m!==null?_(Ve,{label:"Cancel",onClick:()=>p.current?.abort()}):_(Ve,{label:`Try ${S} poses`,class:"primary",isDisabled:S>qh,onClick:()=>{R()},testId:"run-sweep"}),m!==null&&_("span",{class:"hint",role:"status",children:`${m} of ${S}`}),S>qh&&_("span",{class:"problem",children:`At most ${qh} poses.`})]}),g&&_("p",{class:"problem",role:"alert",children:g}),h&&_("div",{class:"scroll-x",children:_(MC,{ranked:h.slice(0,SC),onTake:C})})]})}function fx({name:n,unit:e,span:t,onChange:i}){let[s,r]=e==="m"?[.1,2]:[5,1];return _("div",{class:"triple",children:[_(Rn,{label:`${n} from`,value:t.from,unit:e,step:s,digits:r,onChange:o=>i({...t,from:o})}),_(Rn,{label:"to",value:t.to,unit:e,step:s,digits:r,onChange:o=>i({...t,to:o})}),_(Rn,{label:"steps",value:t.count,step:1,digits:0,minimum:1,maximum:20,onChange:o=>i({...t,count:Math.round(o)})})]})}function MC({ranked:n,onTake:e}){let t=new Set(n.map(({state:i})=>i.model)).size>1;return _("table",{class:"numbers ranking",children:[_("thead",{children:_("tr",{children:[t&&_("th",{scope:"col",children:"OAK"}),_("th",{scope:"col",children:"Height"}),_("th",{scope:"col",children:"Tilt"}),_("th",{scope:"col",children:"Measured"}),_("th",{scope:"col",children:"|Error|"}),_("td",{})]})}),_("tbody",{children:n.map((i,s)=>_("tr",{children:[t&&_("td",{class:"model",children:i.state.model}),_("td",{children:[i.heightM.toFixed(2)," m"]}),_("td",{children:[i.tiltDeg.toFixed(0),"°"]}),_("td",{children:yo(i.coverage.measured)}),_("td",{children:jm(i.coverage.medianAbsoluteErrorM)}),_("td",{children:_(Ve,{label:"Take",class:"text",tip:"Move the selected OAK there",onClick:()=>e(i)})})]},s))})]})}function mx(){let{studio:n}=He(),{target:e}=Ae(n.document);return _(xt,{children:[_(wC,{target:e}),e&&_(RC,{target:e}),e&&_(px,{target:e})]})}function wC({target:n}){let{studio:e,view:t}=He(),i=Ae(e.scene),s=l=>e.document.commit("target",c=>({...c,target:l})),r=Ip(n,i),o=Rr(()=>Xm(i?.objects.map(({path:l})=>l)??[]),[i]),a=()=>{let[l,c]=r??EC(i);s({minimum:l,maximum:c})};return _(en,{title:"Region",testId:"region",children:[_("p",{class:"hint",children:"Which part of the scene must be measured? Choose an object, or a box."}),_("label",{class:"field",children:[_("span",{class:"sr-only",children:"Object"}),_("select",{"data-testid":"target",value:n&&"object"in n?n.object:"",onChange:l=>s(l.currentTarget.value?{object:l.currentTarget.value}:null),children:[_("option",{value:"",children:n&&"minimum"in n?"A box":"Choose an object…"}),o.map(l=>_("option",{value:l,selected:n!==null&&"object"in n&&n.object===l,children:l},l))]})]}),_("div",{class:"row",children:[_(Ve,{label:"Click an object",tip:"The next click in the 3D view chooses the object",onClick:()=>t.get()?.isPicking.set(!0)}),_(Ve,{label:"Box",tip:"A box in the world, at first around the chosen object",isOn:n!==null&&"minimum"in n,onClick:a}),n&&_(Ve,{label:"Clear",class:"text",onClick:()=>s(null)})]}),n&&"minimum"in n&&_("p",{class:"hint",children:"Drag the handles in the 3D view: a square moves a face, the ball the box (with Shift up and down)."}),n&&"minimum"in n&&_(TC,{box:n,onChange:s})]})}function EC(n){if(!n)return[[-1,-1,0],[1,1,1]];let[e,t]=n.bounds,i=n.up==="z"?2:1,s=(o,a)=>Number(((e[o]??0)+((t[o]??0)-(e[o]??0))*a).toFixed(3)),r=(o,a)=>[0,1,2].map(l=>s(l,l===i?a:o));return[r(.25,0),r(.75,.5)]}function TC({box:n,onChange:e}){let t=(i,s,r)=>{let o=[...n[i]];o[s]=r,e({...n,[i]:o})};return _("div",{class:"triple",children:["minimum","maximum"].flatMap(i=>["X","Y","Z"].map((s,r)=>_(Rn,{label:`${s} ${i==="minimum"?"from":"to"}`,value:n[i][r]??0,onChange:o=>t(i,r,o),step:.1,digits:3,unit:"m",...i==="minimum"?{maximum:n.maximum[r]??0}:{minimum:n.minimum[r]??0}},i+s)))})}var AC=400;function CC(n,e,t){let{studio:i}=He(),[s,r]=Pt({answer:null,error:null}),o=JSON.stringify([n,e,t]),a=Tt(o);return a.current=o,Ht(()=>{let l=new AbortController,c=setTimeout(()=>{hn.coverage({scene:n,states:e,region:t},l.signal).then(u=>a.current===o&&r({answer:u,error:null}),u=>{l.signal.aborted||r({answer:null,error:u instanceof Error?u.message:String(u)})})},AC);return()=>{clearTimeout(c),l.abort()}},[o,i]),s}function RC({target:n}){let{studio:e}=He(),{oaks:t,scene:i}=Ae(e.document),s=t.filter(a=>!a.isHidden&&e.hasDepth(a.state)),{answer:r,error:o}=CC(i,s.map(({state:a})=>a),n);return _(en,{title:"Coverage",testId:"coverage",children:[o&&_("p",{class:"problem",role:"alert",children:o}),!r&&!o&&_("p",{class:"hint",children:"Computing…"}),r&&_(LC,{oaks:s,all:t,answer:r}),_(PC,{})]})}function PC(){let{studio:n,view:e}=He(),{paintsCoverage:t}=Ae(n.display),i=Ae(e);return _(xt,{children:[_(Wi,{label:"Paint the surface",tip:"The 3D view shows with the colours of the table what the selected OAK measures of the surface",isOn:t,onChange:s=>n.show({paintsCoverage:s})}),i&&_(IC,{view:i})]})}function IC({view:n}){let{error:e}=Ae(n.painting);return e&&_("p",{class:"problem",role:"alert",children:e})}function LC({oaks:n,all:e,answer:t}){let i=n.flatMap((l,c)=>{let u=t.poses[c];return u?[{oak:l,pose:u}]:[]}),{outcomes:s}=Ae(He().studio.catalog),r=l=>Math.max(...i.map(({pose:c})=>c.lost[l]??0)),a=[...new Set(i.flatMap(({pose:l})=>Object.keys(l.lost)))].sort((l,c)=>r(c)-r(l)).map(l=>({name:l,outcome:s.find(c=>c.name===l)}));return _("div",{class:"scroll-x",children:_("table",{class:"numbers",children:[_("thead",{children:_("tr",{children:[_("td",{}),i.map(({oak:l})=>_("th",{scope:"col","data-tip":l.state.model,children:_(Cc,{index:e.indexOf(l),model:l.state.model,isShort:i.length>2})},l.key))]})}),_("tbody",{children:[_("tr",{children:[_("th",{scope:"row",children:"Visible, %"}),i.map(({oak:l,pose:c})=>_("td",{children:Pr(c.seen)},l.key))]}),_("tr",{children:[_("th",{scope:"row",children:[_("span",{class:"swatch",style:{background:on(xa(0))}}),"Measured, %"]}),i.map(({oak:l,pose:c})=>_("td",{children:_("b",{children:Pr(c.measured)})},l.key))]}),_("tr",{children:[_("th",{scope:"row",children:"Median |error|, mm"}),i.map(({oak:l,pose:c})=>_("td",{children:sr(c.medianAbsoluteErrorM)},l.key))]}),a.map(({name:l,outcome:c})=>_("tr",{children:[_("th",{scope:"row","data-tip":c?.documentation,children:[c&&_("span",{class:"swatch",style:{background:on(xa(c.code))}}),vn(l),", %"]}),i.map(({oak:u,pose:d})=>_("td",{children:Pr(d.lost[l]??0)},u.key))]},l))]})]})})}var DC=["X","Y","Z"],NC=[{key:"yaw",label:"Yaw",tip:"The turn about the vertical axis; positive to the left"},{key:"pitch",label:"Tilt",tip:"The tilt of the optical axis; positive looks down"},{key:"roll",label:"Roll",tip:"The turn about the optical axis; positive to the right"}];function gx(){let{studio:n,view:e}=He(),t=Ae(n.scene),i=Fn(Ae(n.document));if(!i)return null;let s=t?.up??"z",{pose:r}=i.state,o=ds(r.quaternion,s),a=(u,d)=>n.change(`position${u}`,h=>{let f=[...h.pose.position];return f[u]=d,{...h,pose:{...h.pose,position:f}}}),l=(u,d)=>n.change(u,h=>({...h,pose:{...h.pose,quaternion:cc({...ds(h.pose.quaternion,s),[u]:d},s)}}));return _(en,{title:"Pose",actions:_(xt,{children:[_(Ve,{icon:"camera",label:"Look from the OAK",onClick:()=>e.get()?.lookThrough()}),_(Ve,{icon:"reset",label:"Put it where it was at first",onClick:()=>t&&n.change("pose",u=>({...u,pose:t.pose}))})]}),children:_("div",{class:"triple",children:[DC.map((u,d)=>_(Rn,{label:u,value:r.position[d]??0,onChange:h=>a(d,h),step:.05,digits:3,unit:"m",testId:`position-${u.toLowerCase()}`},u)),NC.map(({key:u,label:d,tip:h})=>_(Rn,{label:d,tip:h,value:o[u],onChange:f=>l(u,f),step:1,digits:2,minimum:u==="pitch"?-90:-360,maximum:u==="pitch"?90:360,unit:"°"},u))]})})}var FC=.05,UC=2,Lp=["none","truth","measurement","both"];function vx(n,e){let t=i=>{let{target:s}=i,r=s instanceof HTMLElement&&s.matches("input:not([type=checkbox]), select, textarea");if(OC(n,i)||r||document.querySelector("dialog[open]"))return;(s instanceof HTMLCanvasElement&&BC(n,i)||kC(n,i,e))&&i.preventDefault()};return addEventListener("keydown",t),()=>removeEventListener("keydown",t)}function OC({studio:n},e){if(!(e.ctrlKey||e.metaKey)||e.altKey)return!1;let t=e.key.toLowerCase();return t!=="z"&&t!=="y"?!1:(e.preventDefault(),document.activeElement instanceof HTMLInputElement&&document.activeElement.blur(),t==="y"||e.shiftKey?n.document.redo():n.document.undo(),!0)}function kC(n,e,t){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let{studio:i}=n,s=n.view.get(),r=i.display.get(),o=c=>s?.gizmo.set(s.gizmo.get()===c?"none":c),l={"?":t,1:()=>i.show({showLeft:!r.showLeft}),2:()=>i.show({showRight:!r.showRight}),g:()=>o("translate"),r:()=>o("rotate"),p:()=>i.show({cloud:Lp[(Lp.indexOf(r.cloud)+1)%Lp.length]??"none"}),c:()=>s?.lookThrough(),f:()=>s?.setRiding(!s.isRiding.get()),"[":()=>_x(n,-1),"]":()=>_x(n,1),Home:()=>s?.home(),Escape:()=>{i.hover.set(null),s?.isPicking.set(!1),s?.setRiding(!1)}}[e.key];return l?.(),l!==void 0}function _x({studio:n},e){let t=n.document.get(),i=t.oaks.findIndex(({key:r})=>r===t.selected),s=t.oaks[(i+e+t.oaks.length)%t.oaks.length];s&&n.document.set({...t,selected:s.key})}function BC({studio:n},e){if(e.ctrlKey||e.metaKey||!Fn(n.document.get()))return!1;let t=n.scene.get()?.up??"z",i=FC*(e.shiftKey?.1:1),s=UC*(e.shiftKey?.1:1),r={ArrowUp:[i,0,0],ArrowDown:[-i,0,0],ArrowLeft:[0,i,0],ArrowRight:[0,-i,0],PageUp:[0,0,i],PageDown:[0,0,-i]},o={ArrowUp:{pitch:-s},ArrowDown:{pitch:s},ArrowLeft:{yaw:s},ArrowRight:{yaw:-s}},[a,l]=[r[e.key],o[e.key]];return(e.altKey?!l:!a)?!1:(n.change("keys",c=>({...c,pose:e.altKey?hc(c.pose,l??{},t):uc(c.pose,a??[0,0,0],t)})),!0)}var xx=350;function yx(){let[n,e]=Pt(null),t=Tt(null);if(Ht(()=>{let r=0,o=(d,h)=>{clearTimeout(r);let f=d.target instanceof Element?d.target.closest("[data-tip]"):null;f?r=window.setTimeout(()=>e(f),h):e(null)},a=()=>{clearTimeout(r),e(null)},l=d=>o(d,xx),c=d=>{d.target instanceof Element&&d.target.matches(":focus-visible")&&o(d,xx)},u=d=>d.key==="Escape"&&a();return document.addEventListener("pointerover",l),document.addEventListener("pointerdown",a),document.addEventListener("focusin",c),document.addEventListener("focusout",a),document.addEventListener("keydown",u),()=>{a(),document.removeEventListener("pointerover",l),document.removeEventListener("pointerdown",a),document.removeEventListener("focusin",c),document.removeEventListener("focusout",a),document.removeEventListener("keydown",u)}},[]),hs(()=>{let r=t.current;if(!(!n||!r))return zC(r,n),n.setAttribute("aria-describedby",r.id),()=>n.removeAttribute("aria-describedby")},[n]),!n?.dataset.tip)return null;let[i,...s]=n.dataset.tip.split(`
`);return _("div",{ref:t,id:"tooltip",role:"tooltip",class:"tooltip",children:[_("p",{children:i}),s.map(r=>_("p",{class:"fact",children:r},r))]})}function zC(n,e){let t=e.getBoundingClientRect(),{width:i,height:s}=n.getBoundingClientRect(),r=e.closest(".side");if(r){let c=r.getBoundingClientRect(),u=r.classList.contains("left");n.style.left=`${u?c.right+6:c.left-i-6}px`,n.style.top=`${Math.max(8,Math.min(t.top,innerHeight-s-8))}px`;return}let o=Math.max(8,Math.min(t.left,innerWidth-i-8)),a=t.bottom+6,l=a+s<innerHeight-8?a:Math.max(8,t.top-s-6);n.style.left=`${o}px`,n.style.top=`${l}px`}function bx({icon:n,label:e,children:t,testId:i}){let[s,r]=Pt(!1),o=Tt(null),a=Tt(null),l=()=>r(!1);return Ht(()=>{if(!s)return;let u=d=>{d.target instanceof Node&&!o.current?.contains(d.target)&&l()};return document.addEventListener("pointerdown",u),o.current?.querySelector('[role="menuitem"]')?.focus(),()=>document.removeEventListener("pointerdown",u)},[s]),_("div",{class:"menu-root",ref:o,onKeyDown:u=>{if(u.key==="Escape"&&(l(),a.current?.focus(),u.stopPropagation()),u.key!=="ArrowDown"&&u.key!=="ArrowUp")return;u.preventDefault();let d=[...o.current?.querySelectorAll('[role="menuitem"]')??[]],f=(d.indexOf(document.activeElement)+(u.key==="ArrowDown"?1:-1)+d.length)%d.length;d[f]?.focus()},children:[_("button",{ref:a,type:"button",class:"button","aria-haspopup":"menu","aria-expanded":s,"data-testid":i,onClick:()=>r(!s),children:[_(ic,{name:n}),_("span",{children:e})]}),s&&_("div",{class:"menu",role:"menu","aria-label":e,children:t(l)})]})}async function Sx(n){let e=[...n.querySelectorAll(".panel")],t=e[0]?.querySelector("canvas"),i=e[0]?.parentElement;if(!t||!i||t.clientWidth===0)return null;let s=Math.max(1,t.width/t.clientWidth),r=e.map(f=>f.getBoundingClientRect()),o=Math.min(...r.map(f=>f.left))-10,a=Math.min(...r.map(f=>f.top))-10,l=Math.max(...r.map(f=>f.right))+10,c=Math.max(...r.map(f=>f.bottom))+10,u=new OffscreenCanvas(Math.round((l-o)*s),Math.round((c-a)*s)),d=u.getContext("2d");if(!d)return null;let h=getComputedStyle(n.documentElement);d.scale(s,s),d.translate(-o,-a),d.fillStyle=h.getPropertyValue("--page"),d.fillRect(o,a,l-o,c-a);for(let f of e)VC(d,f,h);return u.convertToBlob({type:"image/png"})}function VC(n,e,t){let i=e.querySelector("figcaption")?.getBoundingClientRect();if(i){let s=["panel-title","panel-oak","panel-fact"].map(r=>e.querySelector(`.${r}`)?.textContent).filter(Boolean);n.fillStyle=t.getPropertyValue("--text"),n.font=`${t.fontSize} system-ui, sans-serif`,n.textBaseline="middle",n.fillText(s.join("  "),i.left,i.top+i.height/2,i.width)}for(let s of e.querySelectorAll("canvas")){let{x:r,y:o,width:a,height:l}=s.getBoundingClientRect();n.save();let c=s.closest(".wiped"),u=c?Number.parseFloat(/([\d.]+)%/.exec(c.style.clipPath)?.[1]??"0")/100*a:0;n.beginPath(),n.rect(r+u,o,a-u,l),n.clip(),n.imageSmoothingEnabled=!1,n.drawImage(s,r,o,a,l),n.restore()}}var GC=[{title:"Asset (USD)",what:{what:"asset",format:"usda"}},{title:"Asset (USDZ)",what:{what:"asset",format:"usdz"}},{title:"Statistics (JSON)",what:{what:"statistics",format:"json"}},{title:"Statistics (CSV)",what:{what:"statistics",format:"csv"}},{title:"Parameters (TOML)",what:{what:"parameters"}}],HC=[{title:"Command line…",what:{what:"command"}},{title:"Python…",what:{what:"python"}}];async function Mx(n,e){let t=n.document.get(),i=Fn(t),s=i&&_i(n.catalog.get(),i.state);if(!i||!s)return null;let r=vo.find(({size:o})=>o===n.display.get().fullSize)?.limit??null;try{return await hn.export({...e,scene:t.scene,state:i.state,size:Sd(s.resolution,r)})}catch(o){return n.report("The export",o),null}}function Ex(n,e){let t=URL.createObjectURL(e),i=document.createElement("a");i.href=t,i.download=n,i.click(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}async function WC(n){let e=await Sx(document);e?Ex("oaktwin-images.png",e):n.notify("warning","No image is shown.")}var wx="The exact values; lengths are metres as 32-bit floating-point numbers";function XC(n){return`${n.length<=4?n.toUpperCase():vn(n)} (ZIP)`}function Tx(){let{studio:n}=He(),e=Ae(n.display),[t,i]=Pt(null),s=e.wipe?[e.wipe.left,e.wipe.right]:e.panels,r=Ui.filter(({kind:l})=>s.includes(l)),o=async l=>{let c=await Mx(n,l);c&&(Ex(c.name,c.file),c.findings.length&&n.notify("note",`${c.name} is saved.`,c.findings))},a=async(l,c)=>{let u=await Mx(n,c);u&&i({title:l.replace("…",""),text:await u.file.text()})};return _(xt,{children:[_(bx,{icon:"download",label:"Export",testId:"export",children:l=>{let c=(u,d,h)=>_("button",{type:"button",role:"menuitem",class:"menu-item","data-tip":h,onClick:()=>{l(),d()},children:u},u);return _(xt,{children:[_("p",{class:"menu-head",children:"Reproduce this state"}),HC.map(({title:u,what:d})=>c(u,()=>{a(u,d)})),_("p",{class:"menu-head",children:"Files"}),GC.map(({title:u,what:d})=>c(u,()=>{o(d)})),_("p",{class:"menu-head",children:"Robots and simulators"}),n.catalog.get().robotFormats.map(({name:u,help:d})=>c(XC(u),()=>{o({what:"robot",format:u})},d)),_("p",{class:"menu-head",children:"Images"}),c("As shown (PNG)",()=>{WC(n)}),r.flatMap(({kind:u,title:d,images:[h]})=>h===void 0?[]:u==="error"?[c(`${d} (NumPy)`,()=>{o({what:"error"})},wx)]:[c(`${d} (PNG)`,()=>{o({what:"image",image:h,format:"png"})}),c(`${d} (NumPy)`,()=>{o({what:"image",image:h,format:"npy"})},wx)])]})}}),t&&_(qC,{title:t.title,text:t.text,onClose:()=>i(null)})]})}function qC({title:n,text:e,onClose:t}){let{studio:i}=He(),[s,r]=Pt(!1);return _(rc,{title:n,onClose:t,children:[_("pre",{class:"code",tabIndex:0,"data-testid":"snippet",children:e}),_("div",{class:"row spread",children:_(Ve,{icon:"copy",label:s?"Copied":"Copy",isNamed:!0,onClick:()=>navigator.clipboard.writeText(e).then(()=>r(!0),a=>i.report("Copying",a)),class:"primary"})})]})}var YC={auto:"dark",dark:"light",light:"auto"};function Ax({onHelp:n}){let{studio:e}=He(),t=Ae(e.scene),i=Ae(e.display),s=Ae(e.catalog);Ae(e.document);let r=Tt(null),o=()=>navigator.clipboard.writeText(e.link()).then(()=>e.notify("note","The link is in the clipboard. It restores this state."),l=>e.report("Copying the link",l)),a=()=>e.document.commit("scene",l=>({...l,scene:s.scene,target:null}));return _("header",{class:"top-bar",children:[_(Ve,{icon:"left",label:"Controls (1)",isOn:i.showLeft,onClick:()=>e.show({showLeft:!i.showLeft})}),_("h1",{children:[_("b",{children:"oaktwin"})," studio"]}),_("div",{class:"scene-name",children:[_("span",{"data-testid":"scene",children:t?.name??"Loading…"}),t&&_("span",{class:"detail",children:[t.triangles.toLocaleString("en")," triangles"]})]}),_(Ve,{icon:"open",label:"Open…",isNamed:!0,tip:"Open a scene or a calibration; or drop its file onto the page",onClick:()=>r.current?.click()}),_("input",{ref:r,type:"file",hidden:!0,multiple:!0,"data-testid":"file",onChange:l=>{nc(e,[...l.currentTarget.files??[]]),l.currentTarget.value=""}}),t&&t.id!==s.scene&&_(Ve,{label:"First scene",class:"text",onClick:a}),_("span",{class:"spring"}),_($C,{}),_(Ve,{icon:"undo",label:"Undo (Ctrl+Z)",isDisabled:!e.document.canUndo,onClick:()=>e.document.undo(),testId:"undo"}),_(Ve,{icon:"redo",label:"Redo (Ctrl+Shift+Z)",isDisabled:!e.document.canRedo,onClick:()=>e.document.redo(),testId:"redo"}),_(Tx,{}),_(Ve,{icon:"link",label:"Copy a link to this state",onClick:o,testId:"link"}),_(Ve,{icon:"theme",label:`Theme: ${i.theme}`,onClick:()=>e.show({theme:YC[i.theme]}),testId:"theme"}),_(Ve,{icon:"help",label:"Keys and help (?)",onClick:n,testId:"help"}),_(Ve,{icon:"right",label:"Numbers (2)",isOn:i.showRight,onClick:()=>e.show({showRight:!i.showRight})})]})}function $C(){let{studio:n}=He(),e=Ae(n.connection),t={open:"Connected",connecting:"Connecting…",lost:"No connection; trying again…"}[e];return _("span",{class:`connection ${e}`,role:"status","data-testid":"connection",children:[_("span",{class:"dot-small"}),e!=="open"&&t,e==="open"&&_("span",{class:"sr-only",children:t})]})}function Cx(n,e){let t=e.trim();if(n.type==="boolean")return t==="true"||t==="false"?{text:t}:{problem:"Enter true or false."};if(n.choices)return n.choices.includes(t)?{text:t}:{problem:`Choose one of ${n.choices.join(", ")}.`};if(n.type==="string")return{text:t};let i=Number(t.replace(",","."));if(t===""||!Number.isFinite(i))return{problem:"Enter a number."};if(n.type==="integer"&&!Number.isInteger(i))return{problem:"Enter a whole number."};let{minimum:s,maximum:r}=n;return s!==null&&i<s||r!==null&&i>r?{problem:`Enter ${Dp(n)}.`}:{text:t.replace(",",".")}}function Dp({type:n,choices:e,minimum:t,maximum:i,unit:s}){let r=t!==null&&t>0&&t<1e-300;if(n==="boolean")return"true or false";if(e)return e.join(", ");let o=s?` ${s}`:"";return r?i===null?`more than 0${o}`:`more than 0, at most ${i}${o}`:t!==null&&i!==null?`${t} to ${i}${o}`:t!==null?`at least ${t}${o}`:i!==null?`at most ${i}${o}`:`any number${o}`}var $h=4;function Rx(n,e,t=1){if(n.type!=="number"&&n.type!=="integer"||n.choices||!Number.isFinite(e))return null;let i=(n.minimum??Math.min(0,$h*e))*t,s=(n.maximum??Math.max(0,$h*e))*t,r=Math.abs(e-i),a=r>0&&s-i>3*$h*r?Number((i+$h*r).toPrecision(2)):s;if(a<=i)return null;let l=n.type==="integer"?1:10**Math.floor(Math.log10((a-i)/200));return{from:i>0&&i<l?l:i,to:a,step:l}}function Px(n){let e=new Map;for(let t of n){let i=e.get(t.group);i?i.push(t):e.set(t.group,[t])}return[...e]}function Ix(n){let e=n.indexOf(":");if(e<0)return{name:n,parameters:{}};let t={};for(let i of n.slice(e+1).split(",")){let s=i.indexOf("=");s>0&&(t[i.slice(0,s).trim()]=i.slice(s+1).trim())}return{name:n.slice(0,e),parameters:t}}function Lx({name:n,parameters:e}){let t=Object.entries(e).map(([i,s])=>`${i}=${s}`);return t.length?`${n}:${t.join(",")}`:n}function ca({parameter:n,value:e,fallback:t,problem:i,onChange:s,reach:r=1}){let{name:o,isEstimate:a}=n,l=e??KC(t),c=e!==void 0&&e!==t,u=d=>{let h=Cx(n,d);return"problem"in h?h.problem:(s(h.text===t?void 0:h.text),null)};return _("div",{class:`parameter ${c?"changed":""}`,"data-parameter":o,"data-tip":JC(n,t),children:[_("div",{class:"parameter-head",children:[_("span",{class:"name",children:vn(o)}),a&&_("span",{class:"badge","data-tip":"The default is an estimate: no source gives it",children:"estimate"}),c&&_(Ve,{icon:"reset",label:`Reset ${vn(o)} to ${t}`,class:"small",onClick:()=>s(void 0)})]}),_(ZC,{parameter:n,shown:l,fallback:t,problem:i,reach:r,onText:u})]})}function ZC({parameter:n,shown:e,fallback:t,problem:i,reach:s,onText:r}){let o=vn(n.name);if(n.type==="boolean")return _("label",{class:"switch",children:[_("input",{type:"checkbox",role:"switch","aria-label":o,checked:e==="true",onChange:u=>r(String(u.currentTarget.checked))}),_("span",{children:e==="true"?"on":"off"}),i&&_("span",{class:"problem",role:"alert",children:i})]});if(n.choices)return _("label",{class:"field",children:[_("span",{class:"sr-only",children:o}),_("select",{value:e,onChange:u=>r(u.currentTarget.value),children:n.choices.map(u=>_("option",{value:u,selected:u===e,children:u},u))}),i&&_("span",{class:"problem",role:"alert",children:i})]});let a=Rx(n,Number(t),s),l=a?.step??(n.type==="integer"?1:.01),c=u=>{let d=n.type==="integer"?Math.sign(u):u*l;r(String(Number((Number(e)+d).toPrecision(9))))};return _("div",{class:"slide",children:[a&&_("input",{type:"range","aria-label":o,min:a.from,max:a.to,step:a.step,value:e,onInput:u=>r(u.currentTarget.value)}),n.type==="string"?_(sc,{label:o,isLabelled:!1,text:e,onText:r,unit:n.unit,problem:i}):_(sc,{label:o,isLabelled:!1,text:e,onText:r,onStep:c,unit:n.unit,problem:i})]})}function KC(n){let e=Number(n);return n.length>8&&Number.isFinite(e)?String(Number(e.toPrecision(6))):n}function JC(n,e){let t=n.unit?` ${n.unit}`:"",i=n.type==="string"&&!n.choices;return[`${n.name}: ${n.documentation}`,...i?[]:[`Range: ${Dp(n)}`],`Default: ${e}${t}`,`Source: ${n.isEstimate?"estimate":n.source}`].join(`
`)}function Dx({filters:n,value:e,ran:t,problem:i,onChange:s}){let r=(e??t).map(Ix),o=(l,c)=>s(l,c.map(Lx)),a=(l,c)=>{let u=r[l];u&&o("order",r.toSpliced(l,1).toSpliced(l+c,0,u))};return _("div",{class:"filters",children:[_("ol",{children:r.map((l,c)=>_("li",{class:"filter",children:[_("div",{class:"parameter-head",children:[_("span",{class:"name",children:vn(l.name)}),_(Ve,{icon:"up",label:`Move ${l.name} up`,class:"small",isDisabled:c===0,onClick:()=>a(c,-1)}),_(Ve,{icon:"down",label:`Move ${l.name} down`,class:"small",isDisabled:c===r.length-1,onClick:()=>a(c,1)}),_(Ve,{icon:"close",label:`Remove ${l.name}`,class:"small",onClick:()=>o("remove filter",r.toSpliced(c,1))})]}),_(QC,{use:l,filter:n.find(({name:u})=>u===l.name),onChange:u=>o(`filter ${c} ${l.name}`,r.with(c,u))})]},`${l.name}${c}`))}),r.length===0&&_("p",{class:"hint",children:"No filter runs."}),i&&_("p",{class:"problem",role:"alert",children:i}),_("div",{class:"row",children:[_("select",{"aria-label":"Add a filter",value:"","data-testid":"add-filter",onChange:l=>{o("add filter",[...r,{name:l.currentTarget.value,parameters:{}}]),l.currentTarget.value=""},children:[_("option",{value:"",children:"Add a filter…"}),n.map(({name:l})=>_("option",{value:l,children:vn(l)},l))]}),e!==null&&_(Ve,{icon:"reset",label:"Use the preset's filters",onClick:()=>s("filters",null)})]})]})}function QC({use:n,filter:e,onChange:t}){if(!e)return null;let i=(s,r)=>{let{[s]:o,...a}=n.parameters;t({...n,parameters:r===void 0?a:{...a,[s]:r}})};return _("div",{class:"filter-parameters",children:e.parameters.map(s=>_(ca,{parameter:s,value:n.parameters[s.name],fallback:s.default,problem:void 0,onChange:r=>i(s.name,r)},s.name))})}var jC=.1,eR=4294967295,Np="population";function Nx({state:n,problem:e}){let{studio:t}=He(),i=(s,r)=>t.change(s,o=>({...o,...r}));return _(en,{title:"Noise and unit",children:[_(Fp,{label:"Noise seed",tip:"Images with the same seed have the same noise",another:"Another seed",value:n.seed,onChange:s=>i("seed",{seed:s}),testId:"seed"}),_(tR,{state:n,problem:e}),_(Wi,{label:"Calibration error",tip:"A random error of the unit's calibration, which biases its disparity, instead of none",isOn:n.deviceSeed!==null,onChange:s=>i("unit",{deviceSeed:s?1:null})}),n.deviceSeed!==null&&_(Fp,{label:"Seed of the error",tip:"Each number is another error",another:"Another error",value:n.deviceSeed,onChange:s=>i("deviceSeed",{deviceSeed:s})})]})}function tR({state:n,problem:e}){let{studio:t}=He(),i=Ae(t.calibrations),s=n.populationSeed!==null?Np:n.calibration??"",r=l=>t.change("device",c=>{let u=l===Np;return{...c,calibration:u?null:l||null,populationSeed:u?c.populationSeed??1:null}}),o=[...i.values()].map(({id:l,name:c})=>({value:l,title:c})),a=n.calibration!==null&&!i.has(n.calibration);return _(xt,{children:[_(ui,{label:"Cameras",testId:"device",value:s,options:[{value:"",title:"Nominal"},{value:Np,title:"A unit of the population"},...o,...a&&n.calibration!==null?[{value:n.calibration,title:"A dropped calibration"}]:[]],onChange:r}),n.populationSeed!==null&&_(Fp,{label:"Unit",tip:"Each number is another device: focal lengths, principal points, distortion and poses differ as those of factory calibrations do",another:"Another unit",value:n.populationSeed,onChange:l=>t.change("populationSeed",c=>({...c,populationSeed:l})),problem:e("populationSeed"),testId:"population-seed"}),i.size===0&&_("p",{class:"hint",children:"Drop a device's calibration file here to model that device."})]})}function Fp({label:n,tip:e,another:t,value:i,onChange:s,problem:r,testId:o}){return _("div",{class:"row end",children:[_(Rn,{label:n,tip:e,value:i,onChange:a=>s(Math.round(a)),step:1,digits:0,minimum:0,maximum:eR,problem:r,...o===void 0?{}:{testId:o}}),_(Ve,{icon:"dice",label:t,onClick:()=>s(Math.floor(Math.random()*1e5))})]})}function Fx({state:n,problem:e}){let{studio:t}=He(),{drift:i}=Ae(t.catalog),s=(o,a)=>t.change(`drift ${o}`,l=>{let{[o]:c,...u}=l.drift;return{...l,drift:a===void 0?u:{...u,[o]:a}}}),r=Object.keys(n.drift).length;return _(en,{title:"Drift",testId:"drift",isOpen:r>0,actions:r>0&&_(Ve,{label:"Reset",class:"text",onClick:()=>t.change("drift",o=>({...o,drift:{}}))}),children:[_("p",{class:"hint",children:"How the stereo pair changed since its calibration: a rotation of the right camera, or the growth of the baseline or of the focal lengths."}),i.map(o=>_(ca,{parameter:o,value:n.drift[o.name],fallback:o.default,problem:e(`drift.${o.name}`),onChange:a=>s(o.name,a),reach:jC},o.name))]})}function Ux(){let{studio:n}=He(),e=nR(),t=Ae(n.catalog),i=Ae(n.rejections).get(e?.key??""),s=Ps(n.frames,d=>JSON.stringify(d.get(e?.key??"")?.header.filters??[])),r=Rr(()=>JSON.parse(s),[s]);if(!e)return null;let{state:o}=e,a=_i(t,o),l=yd(t,o);if(!a)return _("p",{class:"hint pad",children:[o.model," has no depth sensor. Choose another model."]});let c=d=>i?.field===d?i.error:void 0,u=i?.field==="filters"||i?.field?.startsWith("drift.")||l?.parameters.some(({name:d})=>d===i?.field);return _(xt,{children:[_(sR,{state:o,sensor:a,problem:u?void 0:i?.error}),_(Nx,{state:o,problem:c}),a.kind==="stereo"&&_(Fx,{state:o,problem:c}),_(en,{title:"Filters",isOpen:o.filters!==null,children:_(Dx,{filters:t.filters,value:o.filters,ran:r,problem:c("filters"),onChange:(d,h)=>n.change(d,f=>({...f,filters:h}))})}),l&&_(oR,{parameters:l.parameters,state:o,problem:c},l.name)]})}function nR(){let{studio:n}=He(),e=Tt(void 0);return Ps(n.document,t=>{let i=Fn(t),{current:s}=e;return i&&s&&i.key===s.key&&iR(i.state,s.state)?s:(e.current=i,i)})}function iR(n,e){return Object.keys(n).every(t=>t==="pose"||n[t]===e[t])}function sR({state:n,sensor:e,problem:t}){let{studio:i}=He(),s=Ae(i.catalog),r=gi(s,n.model),o=yd(s,n),a=(l,c)=>i.change(l,u=>({...u,...c}));return _(en,{title:"Sensor",children:[(r?.depthSensors.length??0)>1&&_(ui,{label:"Depth sensor",value:n.sensor,options:(r?.depthSensors??[]).map(({id:l})=>({value:l,title:vn(l)})),onChange:l=>{let c=r?.depthSensors.find(u=>u.id===l);a("sensor",{sensor:l,engine:c?.engines[0]??"",preset:null,parameters:{},filters:null})}}),_(ui,{label:"Engine",testId:"engine",value:n.engine,options:e.engines.map(l=>({value:l,title:vn(l)})),onChange:l=>a("engine",{engine:l,parameters:{}})}),o&&_("p",{class:"hint",children:o.help}),e.presets.length>0&&_(ui,{label:"Preset",value:n.preset??"",options:[{value:"",title:"None"},...e.presets.map(l=>({value:l,title:vn(l)}))],onChange:l=>a("preset",{preset:l||null})}),e.kind==="stereo"&&_(Wi,{label:"Extended disparity",tip:"Doubles the disparity range, for near surfaces",isOn:n.extendedDisparity,onChange:l=>a("extended",{extendedDisparity:l})}),e.kind==="stereo"&&_(Wi,{label:"Fisheye lenses",tip:"The optics of the left and right cameras of wide models: fisheye instead of pinhole",isOn:n.lens==="fisheye",onChange:l=>a("lens",{lens:l?"fisheye":"pinhole"})}),e.kind==="stereo"&&_(rR,{state:n,isMatcher:o?.isMatcher??!1,hasProjector:r?.hasProjector??!1}),t&&_("p",{class:"problem",role:"alert",children:t})]})}function rR({state:n,isMatcher:e,hasProjector:t}){let{studio:i}=He(),s=n.ambient===0;return _(xt,{children:[_("div",{class:"row",children:[_("span",{class:"name",id:"light",children:"Light"}),_("div",{class:"segments",role:"group","aria-labelledby":"light",children:[_(Ve,{label:"Day",isOn:!s,onClick:()=>i.change("ambient",r=>({...r,ambient:1}))}),_(Ve,{label:"Night",isOn:s,onClick:()=>i.change("ambient",r=>({...r,ambient:0}))})]})]}),_("div",{class:"pair",children:[_(Rn,{label:"Ambient",tip:"The brightness of the scene's own light in the infrared images; 1 is that of the scene",value:n.ambient,onChange:r=>i.change("ambient",o=>({...o,ambient:r})),step:.1,digits:3,minimum:0,maximum:100}),(t||n.projector>0)&&_(Rn,{label:"Projector",tip:"The brightness of the dot projector; 0 is off, 1 its full power",value:n.projector,onChange:r=>i.change("projector",o=>({...o,projector:r})),step:.1,digits:3,minimum:0,maximum:100})]}),!e&&_("p",{class:"hint",children:"The light changes the left and right images. Only engines that match images measure from them."})]})}function oR({parameters:n,state:e,problem:t}){let{studio:i,defaults:s}=He();Ae(s);let r=Object.keys(e.parameters).length,o=(a,l)=>i.change(`parameter ${a}`,c=>{let{[a]:u,...d}=c.parameters;return{...c,parameters:l===void 0?d:{...d,[a]:l}}});return _(xt,{children:[_("div",{class:"divider",children:[_("h2",{children:"Parameters"}),r>0&&_(Ve,{label:`Reset all ${r}`,class:"text",testId:"reset-all",onClick:()=>i.change("reset",a=>({...a,parameters:{}}))})]}),Px(n).map(([a,l])=>_(en,{title:vn(a),testId:"parameter-group",children:l.map(c=>_(ca,{parameter:c,value:e.parameters[c.name],fallback:s.of(e,c),problem:t(c.name),onChange:u=>o(c.name,u)},c.name))},a))]})}var aR=[{value:"none",title:"No points"},{value:"truth",title:"True points"},{value:"measurement",title:"Measured points"},{value:"both",title:"True and measured"}],lR=[{value:"error",title:"by error"},{value:"depth",title:"by depth"},{value:"reason",title:"by reason"},{value:"oak",title:"by OAK"}];function Ox(){let n=He(),{studio:e,view:t}=n,i=Tt(null);return Ht(()=>{if(!i.current)return;let s=new Xh(e,i.current);return t.set(s),()=>{t.set(null),s.viewer.close()}},[]),_("section",{class:"view","aria-label":"3D view",children:[_("canvas",{ref:i,tabIndex:0,"data-testid":"view","aria-label":"3D view of the scene. W, A, S, D, Q and E fly; arrow keys move the OAK; question mark lists all keys."}),_(cR,{})]})}function cR(){let{studio:n,view:e}=He(),t=Ae(e),i=Ae(n.display),{cloud:s,cloudColor:r}=i;return _(xt,{children:[_("div",{class:"tools top",role:"toolbar","aria-label":"Tools of the 3D view",children:[t&&_(uR,{view:t}),t&&_(hR,{view:t}),_(Ve,{icon:"home",label:"Look at the OAK (Home)",onClick:()=>t?.home()})]}),_("div",{class:"tools layers",role:"toolbar","aria-label":"What the 3D view shows",children:[_(Ve,{label:"Scene",class:"chip",isOn:i.showScene,onClick:()=>n.show({showScene:!i.showScene})}),_(Ve,{label:"Roof",class:"chip",tip:"What is above the OAK, such as a ceiling",isOn:i.showRoof,onClick:()=>n.show({showRoof:!i.showRoof})}),_(Ve,{label:"Cameras",class:"chip",tip:"The fields of view of the cameras",isOn:i.showCameras,onClick:()=>n.show({showCameras:!i.showCameras})}),_(Ve,{label:"Ranges",class:"chip",tip:"The minimum (red), ideal (green) and maximum (orange) distance of the depth sensor",isOn:i.showRanges,onClick:()=>n.show({showRanges:!i.showRanges})}),_(Ve,{label:"Grid",class:"chip",tip:"Squares of one metre",isOn:i.showGrid,onClick:()=>n.show({showGrid:!i.showGrid})}),_(ui,{label:"Point cloud",isLabelled:!1,value:s,options:aR,onChange:o=>n.show({cloud:o}),testId:"cloud"}),s!=="none"&&_(ui,{label:"Colour of the points",isLabelled:!1,value:r,options:lR,onChange:o=>n.show({cloudColor:o})})]}),t&&_(dR,{view:t})]})}function uR({view:n}){let e=Ae(n.gizmo),t=i=>n.gizmo.set(e===i?"none":i);return _(xt,{children:[_(Ve,{icon:"move",label:"Move the OAK (G)",isOn:e==="translate",onClick:()=>t("translate")}),_(Ve,{icon:"turn",label:"Turn the OAK (R)",isOn:e==="rotate",onClick:()=>t("rotate")})]})}function hR({view:n}){let e=Ae(n.isRiding);return _(Ve,{icon:"camera",label:"Fly the OAK: it moves with the view (F)",isOn:e,onClick:()=>n.setRiding(!e)})}function dR({view:n}){let e=Ae(n.detail);return Ae(n.isPicking)?_("div",{class:"note-line",children:"Click an object of the scene. Escape cancels."}):!e||e.shown>=e.of?null:_("div",{class:"note-line",children:[`This view draws ${e.shown.toLocaleString("en")} of ${e.of.toLocaleString("en")} triangles; the images use all. `,_("button",{type:"button",class:"link",onClick:()=>n.loadFullDetail(),children:"Draw all"})]})}function kx(){let n=He(),{studio:e}=n,t=Ae(e.display),[i,s]=Pt(!1);return Ht(()=>vx(n,()=>s(!0)),[]),Ht(()=>{let{theme:r}=t;r==="auto"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=r,n.view.get()?.paintBackground(),n.repaint.update(o=>o+1)},[t.theme]),_("div",{class:`page ${t.showLeft?"":"no-left"} ${t.showRight?"":"no-right"}`,children:[_(Ax,{onHelp:()=>s(!0)}),t.showLeft&&_("aside",{class:"side left","aria-label":"Controls",children:[_(W0,{}),_(gx,{}),_(Ux,{})]}),_(pR,{}),t.showRight&&_(fR,{}),_(H0,{}),_(mR,{}),_(yx,{}),i&&_(tg,{onClose:()=>s(!1)})]})}function fR(){let[n,e]=Pt("inspect");return _("aside",{class:"side right","aria-label":"Numbers",children:[_("div",{class:"tabs",role:"tablist",onKeyDown:s=>{if(s.key!=="ArrowLeft"&&s.key!=="ArrowRight")return;let r=n==="inspect"?"place":"inspect";e(r),document.getElementById(`tab-${r}`)?.focus()},children:[["inspect","Understand"],["place","Place"]].map(([s,r])=>_("button",{type:"button",role:"tab",id:`tab-${s}`,"aria-selected":n===s,tabIndex:n===s?0:-1,"aria-controls":"tab-panel","data-testid":`tab-${s}`,onClick:()=>e(s),children:r},s))}),_("div",{role:"tabpanel",id:"tab-panel","aria-labelledby":`tab-${n}`,children:n==="inspect"?_(G0,{}):_(mx,{})})]})}function pR(){let{studio:n}=He(),{split:e}=Ae(n.display),t=Tt(null),i=o=>n.show({split:Math.max(.12,Math.min(.88,o))}),s=o=>{o.preventDefault();let a=t.current?.getBoundingClientRect();if(!a)return;let l=u=>i((u.clientY-a.top)/a.height),c=()=>removeEventListener("pointermove",l);addEventListener("pointermove",l),addEventListener("pointerup",c,{once:!0})},r=o=>{let a={ArrowUp:-.03,ArrowDown:.03}[o.key];a!==void 0&&(o.preventDefault(),i(e+a))};return _("main",{class:"middle",ref:t,style:{gridTemplateRows:`minmax(0, ${e}fr) 7px minmax(0, ${1-e}fr)`},children:[_(Ox,{}),_("div",{class:"splitter",role:"separator","aria-orientation":"horizontal","aria-label":"Share of the 3D view","aria-valuenow":Math.round(e*100),"aria-valuemin":12,"aria-valuemax":88,tabIndex:0,onPointerDown:s,onKeyDown:r}),_(fg,{})]})}function mR(){let{studio:n}=He(),[e,t]=Pt(!1);return Ht(()=>{let i=a=>a.dataTransfer?.types.includes("Files")??!1,s=a=>{i(a)&&(a.preventDefault(),t(!0))},r=a=>a.relatedTarget===null&&t(!1),o=a=>{i(a)&&(a.preventDefault(),t(!1),nc(n,[...a.dataTransfer?.files??[]]))};return addEventListener("dragover",s),addEventListener("dragleave",r),addEventListener("drop",o),()=>{removeEventListener("dragover",s),removeEventListener("dragleave",r),removeEventListener("drop",o)}},[n]),e?_("div",{class:"drop",children:[_("p",{children:"Drop a scene or a calibration"}),_("span",{children:"It is read, never stored, and stays on this computer."})]}):null}var gR=1e3;function zx({title:n,text:e}){return _("div",{class:"message",role:"alert",children:[_("h1",{children:n}),_("p",{children:e})]})}function _R(){return document.createElement("canvas").getContext("webgl2")!==null}async function vR(n){for(;;)try{let e=await hn.catalog();return new tc(e,await hn.scene(e.scene))}catch(e){zl(_(zx,{title:"No server yet",text:`${e instanceof Error?e.message:String(e)} The page tries again.`}),n),await new Promise(t=>setTimeout(t,gR))}}async function xR(n){if(!_R()){zl(_(zx,{title:"WebGL 2 is missing",text:"This page draws with WebGL 2, which this browser does not offer. Enable hardware acceleration in its settings, update it, or use a current Firefox, Chrome, Edge or Safari. The command line does all of this without a browser: oaktwin render --help."}),n);return}let e=await vR(n),t=new Bt(0),i=new Yl,s=new jl(e),r=new Hl(()=>t.update(l=>l+1)),o={studio:e,defaults:i,painter:r,repaint:t,view:new Bt(null),signals:{painted:0}};e.document.subscribe(()=>r.keep(e.document.get().oaks.map(({key:l})=>l))),zl(_(Ed.Provider,{value:o,children:_(kx,{})}),n);let a=new Ql(e,s,i);window.studio={get isIdle(){return a.isIdle&&(o.view.get()?.isIdle??!1)},get painted(){return o.signals.painted},get drawn(){return o.view.get()?.viewer.drawn??0},get received(){return a.received}}}var Bx=document.getElementById("page");Bx&&xR(Bx);
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
